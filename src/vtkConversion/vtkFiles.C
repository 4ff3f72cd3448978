// SPDX-License-Identifier: GPL-3.0-or-later

#include "vtkFiles.H"
#include "fieldUnits.H"
#include "OSspecific.H"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataWriter.h>

namespace
{

using namespace Foam;

//- VTK's order of a symmetric tensor is xx yy zz xy yz xz
const label vtkOrder[6] = {
    symmTensor::XX,
    symmTensor::YY,
    symmTensor::ZZ,
    symmTensor::XY,
    symmTensor::YZ,
    symmTensor::XZ};
const char* const tensorNames[6] = {"XX", "YY", "ZZ", "XY", "YZ", "XZ"};
const char* const vectorNames[3] = {"X", "Y", "Z"};


void describe(vtkDataArray& array, const word& name)
{
    array.SetName(name.c_str());
    const string units = lpf::unitsOf(name);
    if (!units.empty())
    {
        array.GetInformation()->Set(vtkDataArray::UNITS_LABEL(), units.c_str());
    }
}


void addField(vtkFieldData& data, const word& name, const UList<label>& values)
{
    vtkNew<vtkIntArray> array;
    describe(*array, name);
    array->SetNumberOfValues(values.size());
    forAll (values, i)
    {
        array->SetValue(i, values[i]);
    }
    data.AddArray(array);
}


void addField(vtkFieldData& data, const word& name, const UList<scalar>& values)
{
    vtkNew<vtkDoubleArray> array;
    describe(*array, name);
    array->SetNumberOfValues(values.size());
    forAll (values, i)
    {
        array->SetValue(i, values[i]);
    }
    data.AddArray(array);
}


void addField(vtkFieldData& data, const word& name, const UList<vector>& values)
{
    vtkNew<vtkDoubleArray> array;
    describe(*array, name);
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(values.size());
    for (int d = 0; d < 3; ++d)
    {
        array->SetComponentName(d, vectorNames[d]);
    }
    forAll (values, i)
    {
        array->SetTypedTuple(i, values[i].cdata());
    }
    data.AddArray(array);
}


void addField(
    vtkFieldData& data, const word& name, const UList<symmTensor>& values
)
{
    vtkNew<vtkDoubleArray> array;
    describe(*array, name);
    array->SetNumberOfComponents(6);
    array->SetNumberOfTuples(values.size());
    for (int d = 0; d < 6; ++d)
    {
        array->SetComponentName(d, tensorNames[d]);
    }
    forAll (values, i)
    {
        for (int d = 0; d < 6; ++d)
        {
            array->SetTypedComponent(
                i, d, values[i][static_cast<direction>(vtkOrder[d])]
            );
        }
    }
    data.AddArray(array);
}


template<class T>
void addAll(vtkFieldData& data, const HashTable<Field<T>>& fields)
{
    for (const word& name : fields.sortedToc())
    {
        addField(data, name, fields[name]);
    }
}


vtkSmartPointer<vtkPoints>
vtkPointsOf(const UList<vector>& local, const point& origin)
{
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(local.size());
    forAll (local, i)
    {
        const point x = local[i] + origin;
        points->SetPoint(i, x.cdata());
    }
    return points;
}


void addFrame(vtkFieldData& data, const lpf::vtkFrame& frame)
{
    addField(data, "TimeValue", scalarList(1, frame.time));
    addField(data, "origin", List<vector>(1, frame.origin));
    if (!frame.crs.empty())
    {
        vtkNew<vtkStringArray> crs;
        crs->SetName("crs");
        crs->InsertNextValue(frame.crs.c_str());
        data.AddArray(crs);
    }
}


void writeVtp(const fileName& file, vtkPolyData& data)
{
    mkDir(file.path());
    const fileName part(file + ".part");
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(part.c_str());
    writer->SetInputData(&data);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToZLib();
    // level 1: a third of the time of the default for 5 % larger files
    writer->SetCompressionLevel(1);
    writer->SetHeaderTypeToUInt64();
    if (!writer->Write() || !mv(part, file))
    {
        rm(part);
        FatalErrorInFunction << "Cannot write " << file << nl
                             << "Check permissions and free space"
                             << exit(FatalError);
    }
}

} // namespace


void Foam::lpf::writeCloudVtp(
    const fileName& file, const cloudState& cloud, const vtkFrame& frame
)
{
    vtkNew<vtkPolyData> data;
    data->SetPoints(vtkPointsOf(cloud.positions, frame.origin));

    vtkNew<vtkCellArray> vertices;
    vertices->AllocateExact(cloud.size(), cloud.size());
    for (vtkIdType i = 0; i < cloud.size(); ++i)
    {
        vertices->InsertNextCell(1, &i);
    }
    data->SetVerts(vertices);

    addAll(*data->GetPointData(), cloud.labels);
    addAll(*data->GetPointData(), cloud.scalars);
    addAll(*data->GetPointData(), cloud.vectors);
    addAll(*data->GetPointData(), cloud.symmTensors);
    addFrame(*data->GetFieldData(), frame);
    writeVtp(file, *data);
}


void Foam::lpf::writeGroundVtp(
    const fileName& file,
    const pointField& points,
    const faceList& triangles,
    const labelList& zone,
    const wordList& zoneNames,
    const vtkFrame& frame
)
{
    vtkNew<vtkPolyData> data;
    data->SetPoints(vtkPointsOf(points, frame.origin));

    vtkNew<vtkCellArray> cells;
    cells->AllocateExact(triangles.size(), 3 * triangles.size());
    for (const face& f : triangles)
    {
        cells->InsertNextCell(f.size());
        for (const label corner : f)
        {
            cells->InsertCellPoint(corner);
        }
    }
    data->SetPolys(cells);
    addField(*data->GetCellData(), "zone", zone);

    scalarField elevation(points.size());
    forAll (points, i)
    {
        elevation[i] = points[i].z() + frame.origin.z();
    }
    addField(*data->GetPointData(), "elevation", elevation);

    vtkNew<vtkStringArray> names;
    names->SetName("zoneNames");
    for (const word& name : zoneNames)
    {
        names->InsertNextValue(name);
    }
    data->GetFieldData()->AddArray(names);
    addFrame(*data->GetFieldData(), frame);
    writeVtp(file, *data);
}
