// SPDX-License-Identifier: GPL-3.0-or-later
#include "painter.H"

#include "boundBox.H"
#include "error.H"
#include "OSspecific.H"

#include <vtkAutoInit.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cmath>

VTK_MODULE_INIT(vtkRenderingFreeType)

namespace Foam
{
namespace lpf
{

namespace
{

//- The string as a picture with transparency; false when there is nothing
bool renderText(const string& text, const textStyle& style, vtkImageData* image)
{
    vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
    if (!renderer)
    {
        FatalErrorInFunction
            << "VTK has no text renderer: its module vtkRenderingFreeType is "
            << "not there" << exit(FatalError);
    }
    vtkNew<vtkTextProperty> property;
    property->SetFontFamilyToArial();
    property->SetBold(style.bold);
    property->SetFontSize(int(style.size));
    property->SetColor(style.ink.r, style.ink.g, style.ink.b);
    property->SetOrientation(style.upright ? 90 : 0);

    // At 72 dots per inch a point is a pixel
    int dimensions[2] = {0, 0};
    renderer->SetScaleToPowerOfTwo(false);
    return !text.empty()
        && renderer->RenderString(
            property,
            vtkStdString(text),
            image,
            dimensions,
            72,
            vtkTextRenderer::FreeType
        );
}

scalar distanceToSegment(
    const scalar x, const scalar y, const point& a, const point& b
)
{
    const scalar dx = b.x() - a.x(), dy = b.y() - a.y();
    const scalar length2 = dx * dx + dy * dy;
    const scalar t =
        length2 > 0 ? ((x - a.x()) * dx + (y - a.y()) * dy) / length2 : 0;
    const scalar s = std::clamp(t, scalar(0), scalar(1));
    return std::hypot(x - a.x() - s * dx, y - a.y() - s * dy);
}

bool isInside(const pointField& polygon, const scalar x, const scalar y)
{
    bool inside = false;
    forAll (polygon, k)
    {
        const point& a = polygon[k];
        const point& b = polygon[polygon.fcIndex(k)];
        if ((a.y() > y) != (b.y() > y)
            && x < a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
        {
            inside = !inside;
        }
    }
    return inside;
}

//- Cut a line into dashes: one and a half as long as the gaps
List<pointField> dashes(const pointField& points, const scalar dash)
{
    List<pointField> parts;
    DynamicList<point> part;
    scalar travelled = 0;
    bool drawn = true;
    part.append(points[0]);
    for (label k = 1; k < points.size(); ++k)
    {
        point from = points[k - 1];
        const point& to = points[k];
        while (true)
        {
            const scalar left = (drawn ? 1.5 : 1.0) * dash - travelled;
            const scalar length = mag(to - from);
            if (length < left)
            {
                travelled += length;
                part.append(to);
                break;
            }
            from += left / length * (to - from);
            part.append(from);
            if (drawn)
            {
                parts.append(pointField(part));
            }
            part.clear();
            part.append(from);
            travelled = 0;
            drawn = !drawn;
        }
    }
    if (drawn && part.size() > 1)
    {
        parts.append(pointField(part));
    }
    return parts;
}

} // namespace


painter::painter(const label width, const label height)
    : width_(width), height_(height),
      rgb_(std::size_t(3 * width * height), 1.0F)
{
    clipNothing();
}


void painter::clip(
    const label x0, const label y0, const label x1, const label y1
)
{
    clip_[0] = max(x0, label(0));
    clip_[1] = min(x1, width_);
    clip_[2] = max(y0, label(0));
    clip_[3] = min(y1, height_);
}


void painter::clipNothing()
{
    clip(0, 0, width_, height_);
}


void painter::blend(
    const label x, const label y, const colour& ink, const scalar cover
)
{
    if (x < clip_[0] || x >= clip_[1] || y < clip_[2] || y >= clip_[3]
        || cover <= 0)
    {
        return;
    }
    const scalar c = min(cover, scalar(1));
    float* pixel = rgb_.data() + std::size_t(3 * (x + width_ * y));
    pixel[0] = float(c * ink.r + (1 - c) * scalar(pixel[0]));
    pixel[1] = float(c * ink.g + (1 - c) * scalar(pixel[1]));
    pixel[2] = float(c * ink.b + (1 - c) * scalar(pixel[2]));
}


void painter::fillRectangle(
    const scalar x0,
    const scalar y0,
    const scalar x1,
    const scalar y1,
    const colour ink
)
{
    const auto cover = [](const scalar a, const scalar b, const label k)
    { return min(b, scalar(k + 1)) - max(a, scalar(k)); };

    for (label y = label(std::floor(y0)); y < label(std::ceil(y1)); ++y)
    {
        for (label x = label(std::floor(x0)); x < label(std::ceil(x1)); ++x)
        {
            blend(x, y, ink, cover(x0, x1, x) * cover(y0, y1, y));
        }
    }
}


void painter::fillPolygon(const pointField& polygon, const colour& ink)
{
    if (polygon.size() < 3)
    {
        return;
    }
    const boundBox box(polygon, false);
    const label n = 4; // samples a side of a pixel
    for (label y = label(std::floor(box.min().y())); y <= box.max().y(); ++y)
    {
        for (label x = label(std::floor(box.min().x())); x <= box.max().x();
             ++x)
        {
            label hits = 0;
            for (label k = 0; k < n; ++k)
            {
                const scalar sy = scalar(y) + (scalar(k) + 0.5) / n;
                for (label l = 0; l < n; ++l)
                {
                    const scalar sx = scalar(x) + (scalar(l) + 0.5) / n;
                    hits += label(isInside(polygon, sx, sy));
                }
            }
            blend(x, y, ink, scalar(hits) / (n * n));
        }
    }
}


void painter::segment(
    const point& a, const point& b, const colour& ink, const scalar width
)
{
    // Nothing to do far outside; also keeps the pixel numbers small
    const scalar reach = 0.5 * width + 1;
    const scalar x0 = max(min(a.x(), b.x()) - reach, scalar(clip_[0]));
    const scalar x1 = min(max(a.x(), b.x()) + reach, scalar(clip_[1]));
    const scalar y0 = max(min(a.y(), b.y()) - reach, scalar(clip_[2]));
    const scalar y1 = min(max(a.y(), b.y()) + reach, scalar(clip_[3]));
    for (label y = label(y0); y < y1; ++y)
    {
        for (label x = label(x0); x < x1; ++x)
        {
            const scalar d =
                distanceToSegment(scalar(x) + 0.5, scalar(y) + 0.5, a, b);
            blend(x, y, ink, 0.5 * width + 0.5 - d);
        }
    }
}


void painter::line(const pointField& points, const lineStyle& style)
{
    if (points.size() < 2)
    {
        return;
    }
    pointField flat(points);
    for (point& p : flat)
    {
        p.z() = 0;
    }
    const List<pointField> parts =
        style.dash > 0 ? dashes(flat, style.dash) : List<pointField>(1, flat);
    for (const pointField& part : parts)
    {
        for (label k = 1; k < part.size(); ++k)
        {
            segment(part[k - 1], part[k], style.ink, style.width);
        }
    }
}


void painter::text(
    const scalar x, const scalar y, const string& words, const textStyle& style
)
{
    vtkNew<vtkImageData> image;
    if (!renderText(words, style, image))
    {
        return;
    }
    int n[3];
    image->GetDimensions(n);
    const scalar length = scalar(style.upright ? n[1] : n[0]);
    const scalar back = style.at == anchor::left  ? 0
                      : style.at == anchor::right ? length
                                                  : 0.5 * length;
    const scalar left = style.upright ? x - 0.5 * scalar(n[0]) : x - back;
    const scalar lower = style.upright ? y - back : y - 0.5 * scalar(n[1]);
    const label i0 = label(std::lround(left)), j0 = label(std::lround(lower));

    const auto* rgba =
        static_cast<const unsigned char*>(image->GetScalarPointer());
    for (int j = 0; j < n[1]; ++j)
    {
        for (int i = 0; i < n[0]; ++i)
        {
            const scalar cover = scalar(rgba[4 * (i + n[0] * j) + 3]) / 255;
            blend(i0 + i, j0 + j, style.ink, cover);
        }
    }
}


scalar painter::textWidth(const string& words, const textStyle& style)
{
    vtkNew<vtkImageData> image;
    textStyle level = style;
    level.upright = false;
    return renderText(words, level, image) ? image->GetDimensions()[0] : 0;
}


void painter::write(const fileName& file) const
{
    vtkNew<vtkImageData> image;
    image->SetDimensions(int(width_), int(height_), 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
    std::transform(
        rgb_.begin(),
        rgb_.end(),
        bytes,
        [](const float v)
        { return static_cast<unsigned char>(std::lround(255.0F * v)); }
    );
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(file.c_str());
    writer->Write();
    if (writer->GetErrorCode() != 0 || !isFile(file))
    {
        FatalErrorInFunction << "cannot write " << file << nl
                             << "Is the disk full, is the folder writable?"
                             << exit(FatalError);
    }
}

} // namespace lpf
} // namespace Foam
