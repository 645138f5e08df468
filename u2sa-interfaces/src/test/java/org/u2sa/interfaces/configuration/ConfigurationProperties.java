package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.lifecycle.AfterProperty;
import net.jqwik.api.lifecycle.BeforeProperty;

class ConfigurationProperties {
  private static final String TEXT =
      "<configuration>\n<!-- value=\"1\" > --><variable name='T' type='string' value=''/>\n"
          + "<variable name='D' type='double' value='0'/><variable name='I' type='int' value='0'/>\n"
          + "<variable name='B' type='boolean' value='FALSE'/></configuration>\n";
  private static final VariableDeclaration<Double> D =
      VariableDeclaration.number("D", "").range(Range.of(-1.0e6, 1.0e6));

  private Path file;

  @BeforeProperty
  void write() throws IOException {
    file = Files.createTempFile("u2sa", ".xml");
    Files.write(file, TEXT.getBytes(StandardCharsets.UTF_8));
  }

  @AfterProperty
  void delete() throws IOException {
    Files.delete(file);
  }

  @Property(tries = 80)
  void setVariable_anyText_isReadBackOrRefused(@ForAll String text) throws IOException {
    byte[] before = Files.readAllBytes(file);
    XmlConfiguration configuration = XmlConfiguration.load(file);
    Object old = configuration.getVariable("T");

    boolean set = configuration.setVariable("T", text);

    assertThat(set).isEqualTo(text.codePoints().allMatch(ConfigurationProperties::isXmlCharacter));
    if (set) {
      assertThat(configuration.getVariable("T")).isEqualTo(text);
      assertThat(XmlConfiguration.load(file).getVariable("T")).isEqualTo(text);
    } else {
      assertThat(configuration.getVariable("T")).isEqualTo(old);
      assertThat(Files.readAllBytes(file)).isEqualTo(before);
    }
  }

  private static boolean isXmlCharacter(int c) {
    return c == 0x9
        || c == 0xA
        || c == 0xD
        || c >= 0x20 && c <= 0xD7FF
        || c >= 0xE000 && c <= 0xFFFD
        || c >= 0x10000;
  }

  @Property(tries = 50)
  void setVariable_decimalInRange_isReadBackExactly(
      @ForAll @DoubleRange(min = -1.0e6, max = 1.0e6) double value) {
    XmlConfiguration configuration = XmlConfiguration.load(file);
    configuration.getVariable(D);

    assertThat(configuration.change("D", value)).isEmpty();

    assertThat(configuration.getVariable(D)).isEqualTo(value);
    assertThat(XmlConfiguration.load(file).getVariable(D)).isEqualTo(value);
  }

  @Property(tries = 50)
  void setVariable_anyDecimal_isTakenOnlyInRange(@ForAll double value) {
    XmlConfiguration configuration = XmlConfiguration.load(file);
    configuration.getVariable(D);

    assertThat(configuration.setVariable("D", value)).isEqualTo(value >= -1.0e6 && value <= 1.0e6);
  }

  @Property(tries = 30)
  void setVariable_wholeNumberAndFlag_areReadBack(@ForAll int value, @ForAll boolean flag) {
    XmlConfiguration configuration = XmlConfiguration.load(file);

    assertThat(configuration.change("I", value)).isEmpty();
    assertThat(configuration.change("B", String.valueOf(flag).toUpperCase())).isEmpty();

    assertThat(XmlConfiguration.load(file).getVariable("I")).isEqualTo(value);
    assertThat(XmlConfiguration.load(file).getVariable("B")).isEqualTo(flag);
  }
}
