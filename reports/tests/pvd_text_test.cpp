// SPDX-License-Identifier: MIT
#include "cageproof/reports/pvd_text.h"

#include "cageproof/core/input_error.h"

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLDataParser.h>

#include <sstream>

namespace cageproof::reports {
namespace {

TEST(PvdText, vtk_reads_times_and_files) {
  const std::vector<TimeStep> steps{{1, "a_1.vtp"}, {2.5, "R&D <\"new\"> '2'.vtp"}, {3, "l\xc3\xa4nge.vtp"}};
  std::istringstream text(pvd_text(steps));
  vtkNew<vtkXMLDataParser> parser;
  parser->SetStream(&text);
  ASSERT_TRUE(parser->Parse());
  vtkXMLDataElement* root = parser->GetRootElement();
  ASSERT_STREQ(root->GetName(), "VTKFile");
  EXPECT_STREQ(root->GetAttribute("type"), "Collection");
  vtkXMLDataElement* collection = root->FindNestedElementWithName("Collection");
  ASSERT_NE(collection, nullptr);
  ASSERT_EQ(collection->GetNumberOfNestedElements(), 3);
  for (int k = 0; k < 3; ++k) {
    vtkXMLDataElement* step = collection->GetNestedElement(k);
    EXPECT_STREQ(step->GetName(), "DataSet");
    double time = 0;
    ASSERT_EQ(step->GetScalarAttribute("timestep", time), 1);
    EXPECT_EQ(time, steps[k].time);
    EXPECT_EQ(step->GetAttribute("file"), steps[k].file);
  }
}

TEST(PvdText, names_that_xml_cannot_hold_are_refused) {
  for (const char* name : {"a\n.vtp", "a\x01.vtp", "a\xff.vtp"}) EXPECT_THROW(pvd_text({{1, name}}), InputError);
}

}  // namespace
}  // namespace cageproof::reports
