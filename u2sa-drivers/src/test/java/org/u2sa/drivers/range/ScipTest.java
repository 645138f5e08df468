package org.u2sa.drivers.range;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.frame.Point;

/** SCIP 2 against Hokuyo's own examples and a scan that scripts/sensors/scip.py encoded. */
class ScipTest {
  /** Answer to PP of a URG-04LX, from sourceforge.net/p/urgnetwork/wiki/scip_status_en. */
  private static final List<String> PP =
      List.of(
          "MODL:URG-04LX(Hokuyo Automatic Co.,Ltd.);N",
          "DMIN:20;4",
          "DMAX:5600;_",
          "ARES:1024;\\",
          "AMIN:44;7",
          "AMAX:725;o",
          "AFRT:384;6",
          "SCAN:600;e");

  private static byte[] room() throws IOException {
    try (InputStream stream = ScipTest.class.getResourceAsStream("room.scip")) {
      return stream.readAllBytes();
    }
  }

  private static List<String> scanned() throws IOException {
    ScipReader reader = new ScipReader();
    byte[] bytes = room();
    reader.accept(bytes, bytes.length);
    return reader.take().orElseThrow();
  }

  @Test
  void decode_examplesOfTheSpecification_agree() {
    assertThat(ScipSensor.decode("CB", 0, 2)).isEqualTo(1234);
    assertThat(ScipSensor.decode("1Dh", 0, 3)).isEqualTo(5432);
    assertThat(ScipSensor.decode("m2@0", 0, 4)).isEqualTo(16_000_000);
    assertThat(ScipSensor.decode("1 h", 0, 3)).as("a blank stands for nothing").isEqualTo(-1);
  }

  @Test
  void sum_linesOfRealSensors_agree() {
    assertThat(ScipSensor.isChecked("00P")).isTrue();
    assertThat(ScipSensor.isChecked("99b")).isTrue();
    assertThat(ScipSensor.isChecked("99c")).isFalse();
    assertThat(ScipSensor.isChecked("")).isFalse();
    assertThat(ScipSensor.sum("SERI:H0614967")).isEqualTo('V');
  }

  @Test
  void parameters_answerOfARealSensor_areItsOwn() {
    ScipSensor sensor = ScipSensor.of(PP).orElseThrow();
    assertThat(sensor).isEqualTo(new ScipSensor(20, 5600, 1024, 44, 725, 384, 600));
    assertThat(sensor.stepS()).as("10 turns of 1024 steps a second").isEqualTo(0.1 / 1024);
    assertThat(sensor.azimuth(384)).isZero();
    assertThat(Math.toDegrees(sensor.azimuth(384 + 256))).as("left").isCloseTo(90.0, within(1e-9));
  }

  @Test
  void parameters_wrongSumMissingOrSenseless_areRefused() {
    List<String> wrong = new ArrayList<>(PP);
    wrong.set(1, "DMIN:21;4");
    assertThat(ScipSensor.of(wrong)).isEmpty();
    assertThat(ScipSensor.of(PP.subList(0, 5))).isEmpty();
    wrong.set(1, "DMIN:xx;" + ScipSensor.sum("DMIN:xx"));
    assertThat(ScipSensor.of(wrong)).isEmpty();
    wrong.set(1, PP.get(1));
    wrong.set(3, "ARES:0;" + ScipSensor.sum("ARES:0"));
    assertThat(ScipSensor.of(wrong)).isEmpty();
    wrong.set(3, ";");
    assertThat(ScipSensor.of(wrong)).isEmpty();
  }

  @Test
  void points_scanOfARoom_areItsWalls() throws IOException {
    List<String> answer = scanned();
    assertThat(answer.get(0)).isEqualTo("GD0044072501");
    assertThat(answer.get(1)).isEqualTo("00P");
    ScipSensor sensor = ScipSensor.of(PP).orElseThrow();
    List<OptionalDouble> ranges = sensor.ranges(answer.subList(2, answer.size())).orElseThrow();
    assertThat(ranges).as("none is left out").hasSize(682);
    List<Point> points =
        new RangeScan()
            .minRange(0.02)
            .maxRange(5.6)
            .beams(sensor.azimuth(sensor.firstStep()), sensor.stepRad(), ranges)
            .points();
    // As the script counts: 584 of 682 distances are 20…5600 mm, the others an error code.
    assertThat(points).hasSize(584);
    assertThat(points.stream().mapToDouble(Point::distance).min().orElseThrow())
        .isCloseTo(2.0, within(1.0e-9));
    assertThat(points.stream().mapToDouble(Point::distance).max().orElseThrow())
        .isCloseTo(3.6, within(1.0e-9));
    assertThat(points)
        .as("step 384 is straight ahead, where the wall is")
        .anySatisfy(
            point -> assertThat(point.distanceTo(Point.of(3.0, 0.0, 0.0))).isLessThan(1.0e-9));
    assertThat(points.get(0).azimuth()).as("it begins at the right").isNegative();
  }

  private static String checked(String text) {
    return text + ScipSensor.sum(text);
  }

  @Test
  void ranges_errorCodes_areNoEvidenceOfFreeSpace() {
    ScipSensor sensor = new ScipSensor(20, 5600, 1024, 0, 4, 2, 600);
    List<OptionalDouble> ranges =
        sensor.ranges(List.of(checked("0000"), distances(0, 1, 6, 52, 5617))).orElseThrow();

    assertThat(ranges)
        .containsExactly(
            OptionalDouble.empty(), // out of range
            OptionalDouble.empty(), // too little light, or nothing in range
            OptionalDouble.of(6 * ScipSensor.MILLI), // nearer than DMIN: unknown
            OptionalDouble.of(52 * ScipSensor.MILLI),
            OptionalDouble.empty());
  }

  private static String distances(int... millimetres) {
    StringBuilder text = new StringBuilder();
    for (int mm : millimetres) {
      for (int shift = 12; shift >= 0; shift -= 6) {
        text.append((char) ((mm >> shift & 0x3F) + 0x30));
      }
    }
    return checked(text.toString());
  }

  @Test
  void points_anyCharacterOfAScanTurned_isRefusedOrAnotherAnswer() throws IOException {
    byte[] whole = room();
    ScipSensor sensor = ScipSensor.of(PP).orElseThrow();
    for (int at = 17; at < whole.length - 2; at += 7) { // after echo and status
      byte[] turned = whole.clone();
      turned[at] ^= 0x01;
      ScipReader reader = new ScipReader();
      reader.accept(turned, turned.length);
      Optional<List<OptionalDouble>> ranges =
          reader
              .take()
              .filter(lines -> lines.size() > 2)
              .flatMap(lines -> sensor.ranges(lines.subList(2, lines.size())));
      assertThat(ranges).as("byte " + at).isEmpty();
    }
  }

  @Property(tries = 200)
  void reader_scanInAnyPieces_isTheSameAnswer(@ForAll @IntRange(min = 1, max = 300) int piece)
      throws IOException {
    ScipReader reader = new ScipReader();
    byte[] whole = room();
    for (int from = 0; from < whole.length; from += piece) {
      byte[] part = Arrays.copyOfRange(whole, from, Math.min(from + piece, whole.length));
      reader.accept(part, part.length);
    }
    assertThat(reader.take()).hasValue(scanned());
  }

  @Property(tries = 200)
  void reader_anyBytes_readsTheNextAnswer(@ForAll byte[] noise) {
    ScipReader reader = new ScipReader();
    reader.accept(noise, noise.length);
    byte[] answer = "\n\nQT\n00P\n\n".getBytes(US_ASCII);
    reader.accept(answer, answer.length);
    Optional<List<String>> last = Optional.empty();
    Optional<List<String>> next;
    while ((next = reader.take()).isPresent()) {
      last = next;
    }
    assertThat(last).hasValue(List.of("QT", "00P"));
  }

  @Test
  void reader_endlessLine_isDroppedAndCounted() {
    ScipReader reader = new ScipReader();
    byte[] endless = "x".repeat(5000).getBytes(US_ASCII);
    reader.accept(endless, endless.length);
    byte[] rest = "\nrest\n\nBM\n02R\n\n".getBytes(US_ASCII);
    reader.accept(rest, rest.length);
    assertThat(reader.malformed()).isEqualTo(1);
    assertThat(reader.take()).hasValue(List.of("BM", "02R"));
  }
}
