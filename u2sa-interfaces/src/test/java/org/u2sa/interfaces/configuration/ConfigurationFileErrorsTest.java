package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import org.junit.jupiter.api.Test;

/** What a file must be. */
class ConfigurationFileErrorsTest extends RefusedFile {
  private void assertLoadRefused(String text, String afterTheFile) {
    write(text);
    assertRefused(() -> XmlConfiguration.load(file), afterTheFile);
  }

  private void assertVariableRefused(String attributes, String afterTheFile) {
    assertRefused(() -> configuration("<variable " + attributes + "/>"), afterTheFile);
  }

  @Test
  void load_noFile_saysSo() {
    assertRefused(() -> XmlConfiguration.load(file), ": there is no such file");
  }

  @Test
  void load_directory_saysSo() {
    assertThatThrownBy(() -> XmlConfiguration.load(folder))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(folder + ": is a directory, expected an XML file");
  }

  @Test
  void load_emptyFile_saysSo() {
    assertLoadRefused("", ": is empty, expected an XML file");
  }

  @Test
  void load_tagsCrossed_namesLine() {
    assertLoadRefused(
        "<configuration>\n<variable>\n</configuration>",
        ", line 3: not well-formed XML: Unexpected close tag </configuration>;"
            + " expected </variable>.");
  }

  @Test
  void load_anotherRoot_namesBoth() {
    assertLoadRefused(
        "<!-- a -->\n<mission/>", ", line 2, <mission>: expected the root element <configuration>");
  }

  @Test
  void load_anotherElement_namesTheExpectedOne() {
    assertLoadRefused(
        "<configuration>\n<varible name='A'/></configuration>",
        ", line 2, <varible>: unknown element in <configuration>; expected variable;"
            + " did you mean \"variable\"?");
  }

  @Test
  void load_textBetweenVariables_showsIt() {
    assertLoadRefused(
        "<configuration>hello</configuration>",
        ", line 1, <configuration>: unexpected text \"hello\"");
  }

  @Test
  void load_anotherAttribute_namesTheExpectedOnes() {
    assertVariableRefused(
        "name='A' type='int' vlaue='1'",
        ", line 2, <variable>: unknown attribute \"vlaue\"; expected name, type, value, unit, min,"
            + " max, description; did you mean \"value\"?");
  }

  @Test
  void load_noName_namesLine() {
    assertVariableRefused(
        "type='int' value='1'", ", line 2, <variable>: attribute \"name\" is missing");
  }

  @Test
  void load_emptyName_namesLine() {
    assertVariableRefused(
        "name=' ' type='int' value='1'", ", line 2, <variable>: attribute \"name\" is empty");
  }

  @Test
  void load_noType_namesVariable() {
    assertVariableRefused(
        "name='A' value='1'", ", line 2, variable \"A\": attribute \"type\" is missing");
  }

  @Test
  void load_noValue_namesVariable() {
    assertVariableRefused(
        "name='A' type='int'", ", line 2, variable \"A\": attribute \"value\" is missing");
  }

  @Test
  void load_unknownType_listsTypes() {
    assertVariableRefused(
        "name='A' type='float' value='1'",
        ", line 2, variable \"A\": unknown type \"float\"; expected string, double, int, boolean");
  }

  @Test
  void load_notANumber_showsValue() {
    for (String text : new String[] {"abc", "NaN", "Infinity", "1d", "0x10", "1,5", ""}) {
      assertVariableRefused(
          "name='A' type='double' value='" + text + "'",
          ", line 2, variable \"A\": value \"" + text + "\" is not a number");
    }
  }

  @Test
  void load_numberTooLarge_showsValue() {
    assertVariableRefused(
        "name='A' type='double' value='1e999'",
        ", line 2, variable \"A\": value \"1e999\" is too large for a number");
  }

  @Test
  void load_notAWholeNumber_showsValueAndBounds() {
    for (String text : new String[] {"1.5", "2147483648", ""}) {
      assertVariableRefused(
          "name='A' type='Integer' value='" + text + "'",
          ", line 2, variable \"A\": value \""
              + text
              + "\" is not a whole number from -2147483648 to 2147483647");
    }
  }

  @Test
  void load_notATruthValue_showsValue() {
    assertVariableRefused(
        "name='A' type='BOOLEAN' value='yes'",
        ", line 2, variable \"A\": value \"yes\" is not true or false");
  }

  @Test
  void load_minAboveMax_showsBoth() {
    assertVariableRefused(
        "name='A' type='double' value='1' min='5' max='4'",
        ", line 2, variable \"A\": min 5 is above max 4");
  }

  @Test
  void load_minOfAText_saysWhatItIsFor() {
    assertVariableRefused(
        "name='A' type='string' value='1' min='5'",
        ", line 2, variable \"A\": min and max are for numbers, the type is string");
  }

  @Test
  void load_minNotANumber_showsIt() {
    assertVariableRefused(
        "name='A' type='int' value='1' min='low'",
        ", line 2, variable \"A\": min \"low\" is not a number");
  }

  @Test
  void load_valueOutsideTheFilesOwnLimits_showsRange() {
    assertVariableRefused(
        "name='A' type='double' value='95' unit='deg' min='0' max='60'",
        ", line 2, variable \"A\": 95 deg is outside 0…60 deg");
  }

  @Test
  void load_sameNameTwice_namesBothLines() {
    assertRefused(
        () ->
            configuration(
                "<variable name='A' type='int' value='1'/>\n\n"
                    + "<variable name='A' type='int' value='2'/>"),
        ", line 4, variable \"A\": appears twice; it is in line 2 already");
  }

  @Test
  void load_notUtf8_namesLine() throws IOException {
    Files.write(file, "<configuration>\n<!-- \u00e9 -->".getBytes(StandardCharsets.ISO_8859_1));
    assertRefused(() -> XmlConfiguration.load(file), ", line 2: these bytes are not UTF-8 text");
  }

  @Test
  void load_entityBomb_isRefusedAtItsDoctype() {
    assertLoadRefused(
        "<!DOCTYPE c [<!ENTITY a SYSTEM \"file:///etc/passwd\">]>\n"
            + "<configuration><variable name='A' type='string' value='&a;'/></configuration>",
        ", line 1: a DOCTYPE is not allowed here");
  }

  @Test
  void load_elementsWithoutEnd_areBounded() {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < 10_000; i++) {
      text.append("<a>\n");
    }
    assertLoadRefused(text.toString(), ", line 101: more than 100 elements within each other");
  }
}
