# SPDX-License-Identifier: GPL-3.0-or-later
#
# Prints the flags with which wmake compiles a folder, one line, for tools that
# read C++ (clang-tidy, clangd). In a folder with Make/options, with etc/bashrc
# sourced:
#
#     make -s -f $LPF_PROJECT_DIR/bin/tools/compileFlags.mk

LIB_SRC = $(WM_PROJECT_DIR)/src
GENERAL_RULES = $(WM_DIR)/rules/General
WM_SCRIPTS = $(WM_DIR)/scripts

include $(GENERAL_RULES)/general
# As wmake has preprocessed them: the folder has been built before
include Make/$(WM_OPTIONS)/options

.PHONY: flags
.DEFAULT_GOAL := flags
flags:
	@echo -std=c++17 $(filter-out -Werror,$(c++FLAGS)) \
	    $(EXE_INC) -IlnInclude -I. $(PROJECT_INC) $(GINC)
