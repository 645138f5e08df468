package org.u2sa.drivers.link;

import static org.assertj.core.api.Assertions.assertThatCode;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.Timeout;
import org.u2sa.device.port.Device;
import org.u2sa.drivers.camera.MjpegCamera;
import org.u2sa.drivers.compass.LinkedCompass;
import org.u2sa.drivers.gps.LinkedGps;
import org.u2sa.drivers.gps.NmeaGps;
import org.u2sa.drivers.gps.UbloxModel;
import org.u2sa.drivers.imu.VectorNav;
import org.u2sa.drivers.mavlink.MavlinkProximity;
import org.u2sa.drivers.mavlink.MavlinkTraffic;
import org.u2sa.drivers.motor.RoboClaw;
import org.u2sa.drivers.motor.Vesc;
import org.u2sa.drivers.radar.NmeaRadar;
import org.u2sa.drivers.range.Hokuyo;
import org.u2sa.drivers.range.Rplidar;
import org.u2sa.drivers.range.Velodyne;
import org.u2sa.drivers.sonar.NmeaDepth;
import org.u2sa.drivers.sonar.Ping1d;
import org.u2sa.drivers.sonar.Ping360;
import org.u2sa.drivers.sonar.SerialSonar;
import org.u2sa.drivers.sonar.SonarModel;
import org.u2sa.drivers.traffic.Gdl90Receiver;
import org.u2sa.drivers.water.SerialVelocityLog;
import org.u2sa.drivers.wind.NmeaAnemometer;

/** Whatever bytes a link brings, a driver reads on: noise, frames cut short, absurd content. */
@Timeout(240)
class GarbageOnLinksTest {
  private static final int CHUNKS = 1_500;
  private static final long STEP_MICROS = 20_000;

  /** How frames of the protocols begin, so that noise is taken for content. */
  private static final List<byte[]> BEGINNINGS =
      List.of(
          new byte[] {(byte) 0xb5, 0x62, 0x01, 0x07}, // UBX NAV-PVT
          new byte[] {(byte) 0xfa, 0x01}, // VectorNav, binary
          new byte[] {(byte) 0xa5, 0x5a, 0x05, 0x00, 0x00, 0x40, (byte) 0x81}, // RPLIDAR, a scan
          new byte[] {'B', 'R', 0x20, 0x00}, // Ping
          new byte[] {0x7e, 0x14}, // GDL 90 traffic report
          new byte[] {(byte) 0xff, (byte) 0xd8, (byte) 0xff}, // JPEG
          new byte[] {(byte) 0xfd, 0x20}, // MAVLink 2
          new byte[] {0x02, 0x10, 0x04}, // VESC
          "R123\rR9".getBytes(StandardCharsets.US_ASCII), // MaxBotix
          "MD0000000001000\n99b\n".getBytes(StandardCharsets.US_ASCII), // SCIP
          new byte[] {(byte) 0xff, (byte) 0xee, 0x10, 0x01}, // VLP-16, a block
          "wrz,0.1,".getBytes(StandardCharsets.US_ASCII)); // Water Linked

  private static final List<String> SENTENCES =
      List.of(
          "GPGGA", "GPRMC", "GNGST", "GPGSA", "GPVTG", "HCHDG", "HCHDM", "HCHDT", "SDDBT", "SDDPT",
          "VWVBW", "VNYMR", "VNRRG", "VDVBW", "GPZDA", "WIMWV", "RATTM");
  private static final List<String> FIELDS =
      List.of("", "0", "-1", "1e300", "NaN", "999999999999", "4807.038", "N", "A", "V", "W", "x");

  private static final Map<String, Function<ByteLink, Device<?>>> DEVICES = new LinkedHashMap<>();

  static {
    DEVICES.put("NMEA GPS", link -> LinkedGps.listening(link, new NmeaGps()));
    DEVICES.put("UBX GPS", link -> LinkedGps.ublox(link, UbloxModel.values()[0], 9_600, 5.0));
    DEVICES.put("NMEA compass", LinkedCompass::nmea);
    DEVICES.put("VectorNav", VectorNav::new);
    DEVICES.put("Hokuyo", Hokuyo::new);
    DEVICES.put("RPLIDAR", Rplidar::new);
    DEVICES.put("MaxBotix", link -> new SerialSonar(link, SonarModel.LV));
    DEVICES.put("NMEA depth", NmeaDepth::new);
    DEVICES.put("Ping", link -> new Ping1d(link, 50));
    DEVICES.put("Ping360", link -> new Ping360(link, 20.0, 1_500.0, 1, 1));
    DEVICES.put("RoboClaw", link -> new RoboClaw(link, 0x80, 0.1));
    DEVICES.put("VESC", link -> new Vesc(link, 7));
    DEVICES.put("GDL 90", Gdl90Receiver::new);
    DEVICES.put("Water Linked", SerialVelocityLog::waterLinked);
    DEVICES.put("NMEA log", SerialVelocityLog::nmea);
    DEVICES.put("NMEA anemometer", NmeaAnemometer::new);
    DEVICES.put("NMEA radar", NmeaRadar::new);
    DEVICES.put("VLP-16", Velodyne::new);
    DEVICES.put("MJPEG", link -> new MjpegCamera(link, "/"));
    DEVICES.put("MAVLink traffic", MavlinkTraffic::new);
    DEVICES.put("MAVLink proximity", MavlinkProximity::new);
  }

  @TestFactory
  Stream<DynamicTest> read_garbage_throwsNothing() {
    return DEVICES.entrySet().stream()
        .map(
            each ->
                DynamicTest.dynamicTest(
                    each.getKey(),
                    () ->
                        assertThatCode(() -> feed(each.getValue(), new Random(20L)))
                            .doesNotThrowAnyException()));
  }

  private static void feed(Function<ByteLink, Device<?>> driver, Random random) {
    MemoryLink link = new MemoryLink();
    Device<?> device = driver.apply(link);
    for (int i = 0; i < CHUNKS; i++) {
      link.fromDevice(chunk(random));
      device.read(i * STEP_MICROS);
      device.trouble();
      if (i % 500 == 499) {
        link.unplug();
        device.read(i * STEP_MICROS);
        link.plug();
      }
    }
    device.close();
  }

  private static byte[] chunk(Random random) {
    ByteArrayOutputStream chunk = new ByteArrayOutputStream();
    switch (random.nextInt(4)) {
      case 0 -> chunk.writeBytes(noise(random, 300));
      case 1 -> {
        chunk.writeBytes(BEGINNINGS.get(random.nextInt(BEGINNINGS.size())));
        chunk.writeBytes(noise(random, 100));
      }
      case 2 -> chunk.writeBytes(sentence(random));
      default -> chunk.writeBytes(ubx(random));
    }
    return chunk.toByteArray();
  }

  private static byte[] noise(Random random, int longest) {
    byte[] noise = new byte[random.nextInt(longest)];
    random.nextBytes(noise);
    return noise;
  }

  /** Absurd fields under a checksum that is right. */
  private static byte[] sentence(Random random) {
    StringBuilder text = new StringBuilder(SENTENCES.get(random.nextInt(SENTENCES.size())));
    int fields = random.nextInt(20);
    for (int i = 0; i < fields; i++) {
      text.append(',').append(FIELDS.get(random.nextInt(FIELDS.size())));
    }
    int sum = 0;
    for (int i = 0; i < text.length(); i++) {
      sum ^= text.charAt(i);
    }
    return String.format(Locale.ROOT, "$%s*%02X\r\n", text, sum)
        .getBytes(StandardCharsets.US_ASCII);
  }

  /** An absurd payload under a checksum that is right (u-blox M8 protocol, 32.4). */
  private static byte[] ubx(Random random) {
    byte[] payload = noise(random, 120);
    byte[] frame = new byte[payload.length + 8];
    frame[0] = (byte) 0xb5;
    frame[1] = 0x62;
    frame[2] = 0x01;
    frame[3] = (byte) List.of(0x07, 0x02, 0x03, 0x35, 0x14).get(random.nextInt(5)).intValue();
    frame[4] = (byte) payload.length;
    System.arraycopy(payload, 0, frame, 6, payload.length);
    int a = 0;
    int b = 0;
    for (int i = 2; i < payload.length + 6; i++) {
      a = a + frame[i] & 0xff;
      b = b + a & 0xff;
    }
    frame[payload.length + 6] = (byte) a;
    frame[payload.length + 7] = (byte) b;
    return frame;
  }
}
