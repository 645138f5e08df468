package org.u2sa.drivers.range;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.RangeScan;

/** Slamtec's descriptors and measurements, whole, cut and out of step. */
class RplidarParserTest {
  private static final byte[] SCAN = {
    (byte) 0xA5, 0x5A, 0x05, 0x00, 0x00, 0x40, (byte) 0x81 // as LR001 prints it
  };
  private static final byte[] HEALTH = {(byte) 0xA5, 0x5A, 0x03, 0x00, 0x00, 0x00, 0x06};

  private final RplidarParser parser = new RplidarParser();
  private final List<List<RangeScan.Beam>> scans = new ArrayList<>();

  private void say(byte... bytes) {
    parser.accept(bytes, bytes.length, 1_000);
    parser.takeTurn().ifPresent(turn -> scans.add(turn.beams()));
  }

  /** Turns of 360 measurements, one a degree, 2 m away, and the first 20 of the next. */
  private static byte[] turns(int count) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    for (int i = 0; i < 360 * count + 20; i++) {
      bytes.writeBytes(SimulatedRplidar.node(i % 360 == 0, 15, i % 360, 2.0));
    }
    return bytes.toByteArray();
  }

  @Test
  void accept_health_isRead() {
    parser.reset();
    say(HEALTH);
    say((byte) 2, (byte) 0x03, (byte) 0x80);
    assertThat(parser.health()).hasValue(new RplidarParser.Health(2, 0x8003));
    assertThat(parser.isScanning()).isFalse();
  }

  @Test
  void accept_infoAndBoard_areRead() {
    parser.reset();
    say((byte) 0xA5, (byte) 0x5A, (byte) 0x14, (byte) 0, (byte) 0, (byte) 0, (byte) 0x04);
    byte[] info = new byte[20];
    info[0] = 0x28; // A2M8
    say(info);
    assertThat(parser.model()).hasValue(0x28);
    say((byte) 0xA5, (byte) 0x5A, (byte) 0x04, (byte) 0, (byte) 0, (byte) 0, (byte) 0xFF);
    say((byte) 1, (byte) 0, (byte) 0, (byte) 0);
    assertThat(parser.hasMotorBoard()).hasValue(true);
  }

  /** As Slamtec's SDK sends them. */
  @Test
  void motor_requests_areTheSdks() {
    assertThat(Rplidar.motor(660))
        .isEqualTo(new byte[] {(byte) 0xA5, (byte) 0xF0, 0x02, (byte) 0x94, 0x02, (byte) 0xC1});
    assertThat(Rplidar.motor(0))
        .isEqualTo(new byte[] {(byte) 0xA5, (byte) 0xF0, 0x02, 0x00, 0x00, 0x57});
    assertThat(Rplidar.request(0xFF, 0, 0, 0, 0))
        .isEqualTo(new byte[] {(byte) 0xA5, (byte) 0xFF, 0x04, 0, 0, 0, 0, 0x5E});
  }

  @Test
  void accept_measurement_byHand() {
    parser.reset();
    say(SCAN);
    // quality 47, start; angle 90 degrees = 5760/64; distance 1000 mm = 4000/4
    byte[] node = {(byte) 0xBD, 0x01, 0x2D, (byte) 0xA0, 0x0F};
    assertThat(SimulatedRplidar.node(true, 47, 90.0, 1.0)).isEqualTo(node);
    say(node);
    say(SimulatedRplidar.node(false, 0, 180.0, 0.0));
    say(node);
    assertThat(scans).as("its end may be out of step").isEmpty();
    for (int degree = 91; degree < 107; degree++) {
      say(SimulatedRplidar.node(false, 15, degree, 1.0));
    }
    assertThat(scans).hasSize(1);
    assertThat(scans.get(0))
        .as("clockwise from above: 90 degrees is the right; distance 0 is no echo")
        .containsExactly(
            new RangeScan.Beam(-Math.PI / 2.0, OptionalDouble.of(1.0)),
            new RangeScan.Beam(-Math.PI, OptionalDouble.empty()));
  }

  @Test
  void accept_restOfAScanBeforeTheDescriptor_isPassedOver() {
    parser.reset();
    say(SimulatedRplidar.node(false, 3, 12.0, 0.7));
    say((byte) 0xA5);
    say(SCAN);
    assertThat(parser.isScanning()).isTrue();
    assertThat(parser.malformed()).isZero();
  }

  @Property(tries = 100)
  void accept_anyPieces_areTheSameScans(@ForAll @IntRange(min = 1, max = 5000) int piece) {
    RplidarParser any = new RplidarParser();
    any.reset();
    any.accept(SCAN, SCAN.length, 0);
    byte[] whole = turns(3);
    int count = 0;
    for (int from = 0; from < whole.length; from += piece) {
      int length = Math.min(piece, whole.length - from);
      byte[] part = Arrays.copyOfRange(whole, from, from + length);
      any.accept(part, length, 0);
      count += any.takeTurn().filter(turn -> turn.beams().size() == 360).isPresent() ? 1 : 0;
    }
    assertThat(count).isBetween(piece > 1800 ? 1 : 3, 3);
    assertThat(any.malformed()).isZero();
  }

  @Test
  void accept_oneByteLost_dropsThatScanAndFindsTheNext() {
    parser.reset();
    say(SCAN);
    byte[] five = turns(5);
    for (int i = 0; i < five.length; i++) {
      if (i != 2 * 1800 + 701) {
        say(five[i]);
      }
    }
    assertThat(parser.malformed()).isPositive();
    assertThat(scans).hasSize(4).allSatisfy(scan -> assertThat(scan).hasSize(360));
  }

  @Test
  void accept_randomBytes_makeNoScanAndNoException() {
    parser.reset();
    say(SCAN);
    Random random = new Random(5);
    byte[] noise = new byte[200_000];
    random.nextBytes(noise);
    say(noise);
    assertThat(scans).isEmpty();
    say(turns(2));
    assertThat(scans).isNotEmpty();
    assertThat(scans.get(0)).hasSize(360);
  }

  @Test
  void accept_motorThatStandsStill_doesNotGrowForEver() {
    parser.reset();
    say(SCAN);
    say(SimulatedRplidar.node(true, 15, 10.0, 1.0));
    for (int i = 0; i < 100_000; i++) {
      say(SimulatedRplidar.node(false, 15, 10.0, 1.0));
    }
    assertThat(scans).isEmpty();
  }
}
