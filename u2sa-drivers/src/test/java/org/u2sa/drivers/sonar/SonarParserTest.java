package org.u2sa.drivers.sonar;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.OptionalDouble;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.u2sa.device.port.RangeFinder;

/** MaxBotix's lines: R, digits, carriage return. */
class SonarParserTest {
  private final SerialSonar.SonarParser parser = new SerialSonar.SonarParser(SonarModel.LV);

  private void say(SerialSonar.SonarParser to, String text, long nowMicros) {
    to.accept(text.getBytes(US_ASCII), text.length(), nowMicros);
  }

  @Test
  void accept_line_isMetres() {
    say(parser, "R0", 1);
    say(parser, "50\r", 2);
    assertThat(parser.latest().orElseThrow().measuredAtMicros()).isEqualTo(2);
    assertThat(parser.latest().orElseThrow().rangeM().getAsDouble())
        .isCloseTo(1.27, within(1.0e-9));
    say(parser, "R004\r", 3);
    assertThat(parser.latest().orElseThrow().rangeM().getAsDouble())
        .isCloseTo(0.1524, within(1.0e-9));
    say(parser, "R255\r", 4);
    assertThat(parser.latest()).hasValue(new RangeFinder.Distance(4, OptionalDouble.empty()));
    assertThat(parser.refused()).isZero();
  }

  @Test
  void accept_otherFamilies_haveTheirUnits() {
    SerialSonar.SonarParser xl = new SerialSonar.SonarParser(SonarModel.XL);
    say(xl, "R123\r", 1);
    assertThat(xl.latest().orElseThrow().rangeM().getAsDouble()).isCloseTo(1.23, within(1.0e-9));
    SerialSonar.SonarParser hr = new SerialSonar.SonarParser(SonarModel.HR);
    say(hr, "R1234\r", 1);
    assertThat(hr.latest().orElseThrow().rangeM().getAsDouble()).isCloseTo(1.234, within(1.0e-9));
    say(hr, "R5000\r", 2);
    assertThat(hr.latest().orElseThrow().rangeM()).isEmpty();
  }

  @Test
  void accept_startUpTextTruncatedAndGarbage_goesOnWithTheNextLine() {
    say(parser, "PRINT LV-MaxSonar\rTempI\r\rR0R12\rR1234\rRx\u00ff\r", 1);
    assertThat(parser.latest()).isEmpty();
    assertThat(parser.refused()).isPositive();
    say(parser, "R100\r", 2);
    assertThat(parser.latest().orElseThrow().rangeM().getAsDouble())
        .isCloseTo(2.54, within(1.0e-9));
  }

  @Property
  void accept_anyBytes_readsTheNextLineWhole(@ForAll byte[] noise) {
    SerialSonar.SonarParser any = new SerialSonar.SonarParser(SonarModel.LV);
    any.accept(noise, noise.length, 1);
    say(any, "\rR100\r", 2);
    assertThat(any.latest().orElseThrow().rangeM().getAsDouble()).isCloseTo(2.54, within(1.0e-9));
  }
}
