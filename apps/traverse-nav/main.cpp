// SPDX-FileCopyrightText: 2026 the Traverse authors
// SPDX-License-Identifier: BSD-3-Clause
#include <traverse/nav_app/app.h>

int main(int argc, char** argv)
{
  return static_cast<int>(traverse::app::runNavApp(argc, argv));
}
