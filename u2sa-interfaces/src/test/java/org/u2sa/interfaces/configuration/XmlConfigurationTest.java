package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class XmlConfigurationTest {
  private static final VariableDeclaration<Double> BANK_LIMIT =
      VariableDeclaration.number("BANK LIMIT", "rad")
          .range(Range.of(0.0, Math.toRadians(60.0)))
          .ifAbsent(Math.toRadians(30.0))
          .describedAs("Largest bank.");

  @TempDir Path folder;

  private Path file(String text) throws IOException {
    Path file = folder.resolve("Control.xml");
    Files.write(file, text.getBytes(StandardCharsets.UTF_8));
    return file;
  }

  private static String text(Path file) throws IOException {
    return new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
  }

  @Test
  void getVariable_thesisExample_isItsText() throws IOException {
    Path file =
        file(
            "<configuration>\n"
                + "<variable name=\"COMMUNICATION MANAGER IP\" type=\"string\" value=\"localhost\"/>\n"
                + "</configuration>\n");

    assertThat(XmlConfiguration.load(file).getVariable("COMMUNICATION MANAGER IP"))
        .isEqualTo("localhost");
  }

  @Test
  void getVariable_anotherUnitInFile_isConverted() throws IOException {
    Path file =
        file(
            "<configuration><variable name='BANK LIMIT' type='double' value='60' unit='deg'/>"
                + "</configuration>");

    assertThat(XmlConfiguration.load(file).getVariable(BANK_LIMIT)).isEqualTo(Math.toRadians(60));
  }

  @Test
  void setVariable_commentsAndOddFormatting_onlyTheValueChanges() throws IOException {
    String before =
        "\uFEFF<?xml version=\"1.0\" encoding=\"UTF-8\"?>\r\n<!-- <variable name=\"RATE\" value=\"1\"/> -->\r\n"
            + "<configuration>\r\n\t<variable   value = '%s'\r\n  type=\"double\" name=\"RATE\" /> <!-- Hz é -->\r\n"
            + "  <variable name='A>B' type='string' value='x'></variable>\r\n</configuration>\r\n";
    Path file = file(String.format(before, "5"));
    XmlConfiguration configuration = XmlConfiguration.load(file);

    assertThat(configuration.setVariable("RATE", 7.25)).isTrue();

    assertThat(text(file)).isEqualTo(String.format(before, "7.25"));
    assertThat(configuration.getVariable("RATE")).isEqualTo(7.25);
  }

  @Test
  void setVariable_absentButDeclared_isAddedAsLastChild() throws IOException {
    Path file =
        file(
            "<configuration>\n    <variable name=\"A\" type=\"int\" value=\"1\"/>\n</configuration>\n");
    XmlConfiguration configuration = XmlConfiguration.load(file);
    configuration.getVariable(BANK_LIMIT);

    assertThat(configuration.change("BANK LIMIT", "0.5")).isEmpty();

    assertThat(text(file))
        .isEqualTo(
            "<configuration>\n    <variable name=\"A\" type=\"int\" value=\"1\"/>\n"
                + "    <variable name=\"BANK LIMIT\" type=\"double\" value=\"0.5\" unit=\"rad\"/>\n"
                + "</configuration>\n");
  }

  @Test
  void setVariable_emptyRoot_isOpened() throws IOException {
    Path file = file("<configuration/>\n");
    XmlConfiguration configuration = XmlConfiguration.load(file);
    configuration.getVariable(BANK_LIMIT);

    assertThat(configuration.change("BANK LIMIT", 0.5)).isEmpty();

    assertThat(text(file))
        .isEqualTo(
            "<configuration>\n"
                + "  <variable name=\"BANK LIMIT\" type=\"double\" value=\"0.5\" unit=\"rad\"/>\n"
                + "</configuration>\n");
  }

  @Test
  void inMemory_wholeNumberForDecimalVariable_isRead() {
    XmlConfiguration configuration = XmlConfiguration.inMemory("test", Map.of("BANK LIMIT", 1));

    assertThat(configuration.getVariable(BANK_LIMIT)).isEqualTo(1.0);
    assertThat(configuration.setVariable("BANK LIMIT", 0.25)).isTrue();
    assertThat(configuration.getVariable(BANK_LIMIT)).isEqualTo(0.25);
  }

  @Test
  void resolve_relativePath_isRelativeToTheFile() throws IOException {
    Path file = file("<configuration/>");

    assertThat(XmlConfiguration.load(file).resolve("missions/a.xml"))
        .isEqualTo(folder.resolve("missions/a.xml"));
    assertThat(XmlConfiguration.load(file).resolve("/a.xml")).isEqualTo(Path.of("/a.xml"));
    assertThat(XmlConfiguration.inMemory("none", Map.of()).resolve("a.xml"))
        .isEqualTo(Path.of("a.xml"));
  }

  @Test
  void namedFile_absent_isRefusedNamingFileLineVariableAndValue() throws IOException {
    Path file =
        file(
            "<configuration>\n"
                + "<variable name='MISSION' type='string' value='Mission.xml'/></configuration>");
    XmlConfiguration configuration = XmlConfiguration.load(file);
    Path mission = folder.resolve("Mission.xml");

    assertThatThrownBy(() -> configuration.namedFile("MISSION"))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage(
            file + ", line 2, variable \"MISSION\": \"Mission.xml\": there is no file " + mission);
    Files.writeString(mission, "<mission/>");
    assertThat(configuration.namedFile("MISSION")).isEqualTo(mission);
  }
}
