package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What a file must be. */
class ConfigurationFileErrorsTest extends RefusedFile {
  private void assertLoadRefused(String text, String afterTheFile) {
    write(text);
    assertRefused(() -> XmlConfiguration.load(file), afterTheFile);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          name='A' type='int' vlaue='1' | <variable>: unknown attribute "vlaue"; expected name, type, value, unit, min, max, description; did you mean "value"?
          type='int' value='1' | <variable>: attribute "name" is missing
          name=' ' type='int' value='1' | <variable>: attribute "name" is empty
          name='A' value='1' | variable "A": attribute "type" is missing
          name='A' type='int' | variable "A": attribute "value" is missing
          name='A' type='float' value='1' | variable "A": unknown type "float"; expected string, double, int, boolean
          name='A' type='double' value='1e999' | variable "A": value "1e999" is too large for a number
          name='A' type='BOOLEAN' value='yes' | variable "A": value "yes" is not true or false
          name='A' type='double' value='1' min='5' max='4' | variable "A": min 5 is above max 4
          name='A' type='string' value='1' min='5' | variable "A": min and max are for numbers, but the type is string
          name='A' type='int' value='1' min='low' | variable "A": min "low" is not a number
          name='A' type='double' value='95' unit='deg' min='0' max='60' | variable "A": 95 deg is outside 0…60 deg
          name='B' type='int' value='1'/><variable name='B' type='int' value='2' | variable "B": appears twice; first in line 2
          """)
  void load_wrongVariable_namesLineVariableAndExpectation(String attributes, String expected) {
    assertRefused(() -> configuration("<variable " + attributes + "/>"), ", line 2, " + expected);
  }

  @ParameterizedTest
  @ValueSource(strings = {"abc", "NaN", "Infinity", "1d", "0x10", "1,5", ""})
  void load_notANumber_showsValue(String text) {
    assertRefused(
        () -> configuration("<variable name='A' type='double' value='" + text + "'/>"),
        ", line 2, variable \"A\": value \"" + text + "\" is not a number");
  }

  @ParameterizedTest
  @ValueSource(strings = {"1.5", "2147483648", ""})
  void load_notAWholeNumber_showsValueAndBounds(String text) {
    assertRefused(
        () -> configuration("<variable name='A' type='Integer' value='" + text + "'/>"),
        ", line 2, variable \"A\": value \""
            + text
            + "\" is not a whole number from -2147483648 to 2147483647");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          `` | : is empty, expected an XML file
          <configuration>⏎<variable>⏎</configuration> | , line 3: not well-formed XML: Unexpected close tag </configuration>; expected </variable>.
          <!-- a -->⏎<mission/> | , line 2, <mission>: expected the root element <configuration>
          <configuration>⏎<varible name='A'/></configuration> | , line 2, <varible>: unknown element in <configuration>; expected variable; did you mean "variable"?
          <configuration>hello</configuration> | , line 1, <configuration>: unexpected text "hello"
          <configuration version='1'/> | , line 1, <configuration>: unknown attribute "version"; no attribute is expected here
          <!DOCTYPE c [<!ENTITY a SYSTEM "file:///etc/passwd">]>⏎<configuration><variable name='A' type='string' value='&a;'/></configuration> | , line 1: a DOCTYPE is not allowed here
          """)
  void load_wrongFile_namesLineAndExpectation(String text, String expected) {
    assertLoadRefused(text.replace('⏎', '\n'), expected);
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
  void load_notUtf8_namesLine() throws IOException {
    Files.write(file, "<configuration>\n<!-- \u00e9 -->".getBytes(StandardCharsets.ISO_8859_1));
    assertRefused(() -> XmlConfiguration.load(file), ", line 2: these bytes are not UTF-8 text");
  }

  @Test
  void load_elementsWithoutEnd_areBounded() {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < 10_000; i++) {
      text.append("<a>\n");
    }
    assertLoadRefused(text.toString(), ", line 101: more than 100 nested elements");
  }
}
