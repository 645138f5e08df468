package org.u2sa.flightgear.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.EnumMap;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.assertj.core.data.Offset;

final class OutLineProperties {
  private static final double FEET_AT_REST = 21.88;

  /** As FlightGear's c172p said it on the runway of PHNL. */
  private static final String PARKED =
      "8.391666667,21.325246650,-157.943183840,21.880000000,4.050000000,-0.100000000,4.400000000,89.970000000,"
          + "0.000000000,0.000000000,0.000000000,0.000000000,0.000000000,0.000000000,0.040000000,"
          + "0.000000000,-16.880000000,0.000000000,790.000000000,1.000000000,0.000000000,0.000000000,17.000000000";

  @Example
  void parse_lineOfFlightGear_convertsUnits() throws MalformedLineException {
    OutLine line = OutLine.parse(PARKED);
    assertThat(line.get(OutField.LATITUDE)).isEqualTo(21.325246650);
    assertThat(line.get(OutField.ALTITUDE)).isCloseTo(FEET_AT_REST * 0.3048, Offset.offset(1e-12));
    assertThat(line.get(OutField.HEIGHT)).isCloseTo(OutLine.STANDING_M, Offset.offset(1e-12));
    assertThat(line.get(OutField.HEADING)).isCloseTo(Math.toRadians(89.97), Offset.offset(1e-12));
    assertThat(line.get(OutField.CALIBRATED_AIRSPEED)).isCloseTo(0.0205778, Offset.offset(1e-6));
    assertThat(line.get(OutField.AIR_RIGHT)).isCloseTo(-5.145, Offset.offset(1e-3));
    assertThat(line.get(OutField.ENGINE_SPEED)).isEqualTo(790.0);
    assertThat(line.isSet(OutField.WEIGHT_ON_WHEEL)).isTrue();
    assertThat(line.isSet(OutField.PRIMER)).isFalse();
    assertThat(line.isBeforeFlight()).isFalse();
  }

  @Property(tries = 200)
  void parse_formatted_isTheSameWithinTheLastDigit(@ForAll Random random)
      throws MalformedLineException {
    Map<OutField, Double> values = new EnumMap<>(OutField.class);
    for (OutField field : OutField.values()) {
      values.put(field, field.unit().toUsed(0.001 + 0.998 * random.nextDouble()));
    }
    OutLine line = OutLine.of(values);
    OutLine read = OutLine.parse(line.format());
    for (OutField field : OutField.values()) {
      assertThat(read.get(field))
          .as(field.name())
          .isCloseTo(values.get(field), Offset.offset(1e-9));
    }
    assertThat(OutLine.parse(read.format())).isEqualTo(read).hasSameHashCodeAs(read);
  }

  @Property(tries = 500)
  void parse_anyText_givesALineOrSaysWhy(@ForAll String text) {
    readsOrRefuses(text);
  }

  @Property(tries = 1_000)
  void parse_lineWithBytesChanged_takesNoNumberOutsideItsRange(
      @ForAll Random random, @ForAll @IntRange(min = 1, max = 5) int changes) {
    StringBuilder line = new StringBuilder(PARKED);
    for (int i = 0; i < changes; i++) {
      line.setCharAt(random.nextInt(line.length()), (char) random.nextInt(256));
    }
    readsOrRefuses(line.toString());
  }

  @Property
  void parse_lineCutInAField_isRefused(@ForAll @IntRange(max = 150) int length) {
    assertThatThrownBy(() -> OutLine.parse(PARKED.substring(0, length)))
        .isInstanceOf(MalformedLineException.class)
        .hasMessageContaining("fields, expected " + OutField.values().length);
  }

  @Property
  void parse_twoLinesInOne_isRefused(@ForAll @IntRange(min = 2, max = 250) int kept) {
    assertThatThrownBy(
            () -> OutLine.parse(PARKED.substring(0, Math.min(kept, PARKED.length())) + PARKED))
        .isInstanceOf(MalformedLineException.class);
  }

  @Property
  void parse_numberOutsideItsRange_namesFieldValueAndRange(
      @ForAll @DoubleRange(min = 90.01, max = 1e6) double latitude) {
    String line = PARKED.replace("21.325246650", String.format(Locale.ROOT, "%.6f", latitude));
    assertThatThrownBy(() -> OutLine.parse(line))
        .isInstanceOf(MalformedLineException.class)
        .hasMessageStartingWith("/position/latitude-deg: ")
        .hasMessageEndingWith(" is outside -90.0…90.0 deg");
  }

  @Example
  void parse_whatJavaTakesForANumberButFlightGearNeverSends_isRefused() {
    for (String text :
        new String[] {
          "",
          " 1",
          "1d",
          "1f",
          "0x1p3",
          "NaN",
          "nan",
          "-nan",
          "Infinity",
          "inf",
          "1e999",
          "--1",
          "1.2.3",
          "۱"
        }) {
      assertThatThrownBy(() -> OutLine.parse(PARKED.replace("-157.943183840", text)))
          .as(text)
          .isInstanceOf(MalformedLineException.class)
          .hasMessage(
              "/position/longitude-deg: \"" + text.replace('۱', '?') + "\" is not a number");
    }
  }

  @Example
  void parse_lineFromBeforeTheFlightModel_isMarked() throws MalformedLineException {
    assertThat(OutLine.parse(PARKED.replace("8.391666667", "0.000000000")).isBeforeFlight())
        .isTrue();
    assertThat(OutLine.parse(PARKED.replace("21.880000000", "-9999.000000")).isBeforeFlight())
        .isTrue();
  }

  @Example
  void of_notFinite_isRefused() {
    assertThatThrownBy(() -> OutLine.of(Map.of(OutField.PITCH, Double.NaN)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("PITCH: NaN");
  }

  private static void readsOrRefuses(String text) {
    OutLine line;
    try {
      line = OutLine.parse(text);
    } catch (MalformedLineException refused) {
      assertThat(refused.getMessage()).isNotBlank().hasSizeLessThan(200);
      return;
    }
    for (OutField field : OutField.values()) {
      assertThat(line.isBeforeFlight() || field.isPlausible(field.unit().toLine(line.get(field))))
          .as(text)
          .isTrue();
    }
  }
}
