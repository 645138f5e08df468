package org.u2sa.interfaces.xml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.BadInputException;

class XmlReaderTest {
  @TempDir Path folder;

  private static XmlElement read(String text) {
    return read(text, StandardCharsets.UTF_8);
  }

  private static XmlElement read(String text, Charset charset) {
    return XmlReader.read(new ByteArrayInputStream(text.getBytes(charset)), "m.xml", "mission");
  }

  private static void assertRefused(String text, String message) {
    assertThatThrownBy(() -> read(text)).isInstanceOf(BadInputException.class).hasMessage(message);
  }

  @Test
  void read_thesisWaypoint_hasItsFieldsAndLines() {
    XmlElement mission =
        read(
            "<mission>\n<waypoint>\n  <name>1</name>\n  <next>2</next>\n"
                + "  <reference>Global</reference>\n  <x>10</x>\n  <y unit='deg'> 15 </y>\n"
                + "</waypoint>\n</mission>");

    XmlElement waypoint = mission.child("waypoint").get();
    assertThat(waypoint.line()).isEqualTo(2);
    assertThat(waypoint.origin()).isEqualTo("m.xml");
    assertThat(waypoint.children())
        .extracting(XmlElement::name)
        .containsExactly("name", "next", "reference", "x", "y");
    XmlElement y = waypoint.child("y").get();
    assertThat(y.text()).isEqualTo("15");
    assertThat(y.line()).isEqualTo(7);
    assertThat(y.attribute("unit")).isEqualTo("deg");
    assertThat(y.optionalAttribute("frame")).isEmpty();
    assertThat(y.toString()).isEqualTo("m.xml, line 7, <y>");
  }

  /** Found by fuzzing: the command line and the log take a message for one line. */
  @Test
  void read_lineEndsInWhatIsQuoted_messageIsOneLine() {
    assertRefused(
        "<?xml version='1.0' encoding='UTF\n\n9'?><mission/>",
        "m.xml, line 1: unknown encoding \"UTF 9\"; expected UTF-8");
    assertThatThrownBy(() -> read("<mission a='1'/>").refuseUnknownAttributes("b\u2028c"))
        .hasMessage("m.xml, line 1, <mission>: unknown attribute \"a\"; expected b c");
  }

  @Test
  void read_file_namesItAsTheUserDid() throws IOException {
    Path file = Files.write(folder.resolve("a.xml"), "<mission/>".getBytes(StandardCharsets.UTF_8));

    assertThat(XmlReader.read(file, "mission").origin()).isEqualTo(file.toString());
  }

  @Test
  void read_cdataEntitiesAndComments_areText() {
    XmlElement mission = read("<mission>a &lt;<!-- no --><![CDATA[<b>]]>&#8364;</mission>");

    assertThat(mission.text()).isEqualTo("a <<b>€");
  }

  @Test
  void read_utf16WithByteOrderMark_isDecoded() {
    assertThat(
            read(
                    "<?xml version='1.0' encoding='UTF-16'?><mission>é</mission>",
                    StandardCharsets.UTF_16)
                .text())
        .isEqualTo("é");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          <?xml version='1.0' encoding='KLINGON-8'?><mission/> | 1: unknown encoding "KLINGON-8"; expected UTF-8
          <mission>⏎<home><x>1</x> 5 </home></mission> | 2, <home>: text "5" is between its elements
          <mission>⏎&nbsp;</mission> | 2: not well-formed XML: Undeclared general entity "nbsp"
          <mission a='1' a='2'/> | 1: not well-formed XML: Duplicate attribute 'a'.
          """)
  void read_wrongText_isRefusedInItsLine(String text, String expected) {
    assertRefused(text.replace('⏎', '\n'), "m.xml, line " + expected);
  }

  @Test
  void read_fileOfAnotherKind_isRefusedUnquoted() {
    assertRefused(
        "\n root:x:0:0", "m.xml, line 2: not well-formed XML: expected < at its beginning");
    assertThat(read("\n <mission/>").name()).isEqualTo("mission");
  }

  @Test
  void read_secondRoot_isRefused() {
    assertThatThrownBy(() -> read("<mission/>\n<mission/>"))
        .isInstanceOf(BadInputException.class)
        .hasMessageStartingWith("m.xml, line 2: not well-formed XML: ");
  }

  @Test
  void read_streamThatFails_namesOrigin() {
    InputStream failing =
        new InputStream() {
          @Override
          public int read() throws IOException {
            throw new IOException("pulled out");
          }
        };
    assertThatThrownBy(() -> XmlReader.read(failing, "m.xml", "mission"))
        .isInstanceOf(BadInputException.class)
        .hasMessage("m.xml: cannot be read: pulled out");
  }

  @Test
  void attribute_missing_isRefused() {
    assertThatThrownBy(() -> read("<mission/>").attribute("name"))
        .hasMessage("m.xml, line 1, <mission>: attribute \"name\" is missing");
  }

  @Test
  void child_twice_namesBothLines() {
    XmlElement mission = read("<mission>\n<home/>\n<home/></mission>");

    assertThat(mission.children("home")).hasSize(2);
    assertThatThrownBy(() -> mission.child("home"))
        .hasMessage("m.xml, line 3, <home>: appears twice in <mission>; first in line 2");
  }

  @Test
  void refuseUnknownChildren_misspelt_suggests() {
    assertThatThrownBy(() -> read("<mission><hmoe/></mission>").refuseUnknownChildren("home", "x"))
        .hasMessage(
            "m.xml, line 1, <hmoe>: unknown element in <mission>; expected home, x;"
                + " did you mean \"home\"?");
  }

  @Test
  void refuseUnknownAttributes_noneExpected_saysSo() {
    assertThatThrownBy(() -> read("<mission a='1'/>").refuseUnknownAttributes())
        .hasMessage(
            "m.xml, line 1, <mission>: unknown attribute \"a\"; no attribute is expected here");
  }

  @Test
  void read_childlessAndExtendedTags_keepTheirSpan() {
    XmlText text =
        XmlText.of("<mission><a><b/></a></mission>".getBytes(StandardCharsets.UTF_8), "m.xml");
    XmlElement b = text.root("mission").child("a").get().child("b").get();

    assertThat(
            new String(
                text.withLastChild(b, "c", java.util.Map.of()).bytes(), StandardCharsets.UTF_8))
        .isEqualTo("<mission><a><b>\n  <c/>\n</b></a></mission>");
  }
}
