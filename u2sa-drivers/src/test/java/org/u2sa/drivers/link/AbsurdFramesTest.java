package org.u2sa.drivers.link;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.function.BiFunction;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.Timeout;
import org.u2sa.device.CompassSensor;
import org.u2sa.device.GpsSensor;
import org.u2sa.device.ImuSensor;
import org.u2sa.device.LidarSensor;
import org.u2sa.device.PointCloudSensor;
import org.u2sa.device.RadarSensor;
import org.u2sa.device.RangeSensor;
import org.u2sa.device.SonarSensor;
import org.u2sa.device.ThrusterActuator;
import org.u2sa.device.TrafficSensor;
import org.u2sa.device.WaterSpeedSensor;
import org.u2sa.device.WheelMotors;
import org.u2sa.device.WindSensor;
import org.u2sa.device.payload.PingerSensor;
import org.u2sa.drivers.compass.LinkedCompass;
import org.u2sa.drivers.gps.LinkedGps;
import org.u2sa.drivers.gps.NmeaGps;
import org.u2sa.drivers.gps.UbxGps;
import org.u2sa.drivers.imu.VectorNav;
import org.u2sa.drivers.mavlink.MavlinkAutopilot;
import org.u2sa.drivers.mavlink.MavlinkProximity;
import org.u2sa.drivers.mavlink.MavlinkTraffic;
import org.u2sa.drivers.motor.RoboClaw;
import org.u2sa.drivers.motor.Vesc;
import org.u2sa.drivers.radar.NmeaRadar;
import org.u2sa.drivers.range.Hokuyo;
import org.u2sa.drivers.range.Rplidar;
import org.u2sa.drivers.range.Velodyne;
import org.u2sa.drivers.range.VelodynePackets;
import org.u2sa.drivers.sonar.NmeaDepth;
import org.u2sa.drivers.sonar.NmeaHydrophones;
import org.u2sa.drivers.sonar.Ping1d;
import org.u2sa.drivers.sonar.Ping360;
import org.u2sa.drivers.sonar.SerialSonar;
import org.u2sa.drivers.sonar.SonarModel;
import org.u2sa.drivers.traffic.AisReceiver;
import org.u2sa.drivers.traffic.Gdl90Receiver;
import org.u2sa.drivers.water.SerialVelocityLog;
import org.u2sa.drivers.wind.NmeaAnemometer;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;
import org.u2sa.testkit.ServiceKit;

/**
 * Garbage, and frames with any content under right checksums, one protocol family at a time: no
 * exception leaves a service's step, so none fails.
 */
@Timeout(240)
class AbsurdFramesTest {
  private static final double SECONDS = 20.0;
  private static final int CHUNKS = 1_500; // of garbage

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
          new byte[] {(byte) 0xff, (byte) 0xee, 0x10, 0x01}, // VLP-16
          "R123\rR9".getBytes(StandardCharsets.US_ASCII), // MaxBotix
          "MD0000000001000\n99b\n".getBytes(StandardCharsets.US_ASCII), // SCIP
          "wrz,0.1,".getBytes(StandardCharsets.US_ASCII)); // Water Linked

  /** A device that says absurd things. */
  private interface Speaker {
    /** What it says by itself; empty if it only answers. */
    byte[] frame(Random random);

    /** What it answers. */
    default byte[] answer(Random random, byte[] request) {
      return new byte[0];
    }
  }

  private record Pair(
      BiFunction<ServiceContext, MemoryLink, U2SAService> service, Speaker device) {}

  private final Map<String, Pair> families = new TreeMap<>();

  private void add(
      String name, BiFunction<ServiceContext, MemoryLink, U2SAService> service, Speaker device) {
    families.put(name, new Pair(service, device));
  }

  private void addMavlink() {
    int[][] autopilot = {{0, 9}, {1, 43}, {24, 52}, {30, 28}, {33, 28}, {147, 54}, {253, 54}};
    add(
        "MAVLink autopilot",
        MavlinkAutopilot::new,
        random -> {
          int[] message = autopilot[random.nextInt(autopilot.length)];
          return Frames.mavlink(random, message[0], message[1]);
        });
    add(
        "MAVLink traffic",
        (context, link) -> new TrafficSensor(context, new MavlinkTraffic(link)),
        random -> Frames.mavlink(random, 246, 38));
    add(
        "MAVLink proximity",
        (context, link) -> new LidarSensor(context, new MavlinkProximity(link)),
        Frames::obstacles);
  }

  private void addNmea() {
    String[] gps = {
      "GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,",
      "GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W",
      "GNGST,123519,1.0,1.0,1.0,0.0,1.0,1.0,2.0",
      "GPGSA,A,3,04,05,,09,12,,,24,,,,,2.5,1.3,2.1",
      "GPVTG,054.7,T,034.4,M,005.5,N,010.2,K"
    };
    add(
        "NMEA GPS",
        (context, link) -> new GpsSensor(context, LinkedGps.listening(link, new NmeaGps())),
        random -> Frames.nmea(random, gps[random.nextInt(gps.length)]));
    add(
        "NMEA compass",
        (context, link) -> new CompassSensor(context, LinkedCompass.nmea(link)),
        random ->
            Frames.nmea(random, random.nextBoolean() ? "HCHDG,98.3,0.0,E,12.6,W" : "HCHDT,98.3,T"));
    add(
        "VectorNav",
        (context, link) -> new ImuSensor(context, new VectorNav(link)),
        random ->
            Frames.nmea(
                random,
                "VNYMR,+010.071,+000.278,-002.026,-00.2866,+00.0386,+02.9832,+00.048,-00.137,"
                    + "-09.803,-00.001222,-00.000450,-00.001218"));
    add(
        "NMEA depth",
        (context, link) -> new RangeSensor(context, new NmeaDepth(link)),
        random ->
            Frames.nmea(
                random, random.nextBoolean() ? "SDDPT,12.3,0.5" : "SDDBT,40.4,f,12.3,M,6.7,F"));
    add(
        "NMEA log",
        (context, link) -> new WaterSpeedSensor(context, SerialVelocityLog.nmea(link)),
        random ->
            Frames.nmea(
                random,
                random.nextBoolean() ? "VDVBW,1.0,0.1,A,1.1,0.2,A" : "VWVHW,,T,,M,2.1,N,3.9,K"));
    add(
        "NMEA anemometer",
        (context, link) -> new WindSensor(context, new NmeaAnemometer(link)),
        random -> Frames.nmea(random, "WIMWV,214.8,R,10.1,K,A"));
    add(
        "NMEA hydrophones",
        (context, link) -> new PingerSensor(context, new NmeaHydrophones(link)),
        random -> Frames.nmea(random, "YXPNG,25000,214.8,-10.1,2.5"));
    add(
        "NMEA radar",
        (context, link) -> new RadarSensor(context, new NmeaRadar(link)),
        random -> Frames.nmea(random, "RATTM,11,11.4,13.6,T,7.0,20.0,T,0.0,0.0,N,,T,,154125.82,A"));
  }

  private void addBinarySensors() {
    int[][] ubx = {{0x07, 92}, {0x02, 28}, {0x12, 36}, {0x06, 52}, {0x03, 16}};
    add(
        "UBX GPS",
        (context, link) -> new GpsSensor(context, LinkedGps.listening(link, new UbxGps())),
        random -> {
          int[] message = ubx[random.nextInt(ubx.length)];
          return Frames.ubx(random, message[0], message[1]);
        });
    add(
        "AIS",
        (context, link) -> new TrafficSensor(context, new AisReceiver(link)),
        random -> Frames.nmea(random, "AIVDM,1,1,,A,15MgK45P3@G?fl0E`JbR0OwT0@MS,0"));
    add(
        "GDL 90",
        (context, link) -> new TrafficSensor(context, new Gdl90Receiver(link)),
        Frames::gdl90);
    add(
        "Ping",
        (context, link) -> new RangeSensor(context, new Ping1d(link, 50)),
        random -> Frames.ping(random, 1211, 5));
    add(
        "Ping360",
        (context, link) -> new SonarSensor(context, new Ping360(link, 20.0, 1_500.0, 1, 1)),
        Frames::ping360);
    add(
        "Water Linked",
        (context, link) -> new WaterSpeedSensor(context, SerialVelocityLog.waterLinked(link)),
        Frames::waterLinked);
  }

  private void addRangeFinders() {
    byte[] revolutions = VelodynePackets.revolutions(3, (azimuth, elevation) -> 5.0);
    int[] sent = {0};
    add(
        "VLP-16",
        (context, link) -> new PointCloudSensor(context, new Velodyne(link)),
        random -> {
          byte[] packet = Arrays.copyOfRange(revolutions, sent[0], sent[0] + 1206);
          sent[0] = (sent[0] + 1206) % revolutions.length;
          random.ints(2, 0, 1200).forEach(at -> packet[at] = (byte) random.nextInt());
          return packet;
        });
    add(
        "MaxBotix",
        (context, link) -> new RangeSensor(context, new SerialSonar(link, SonarModel.LV)),
        random -> String.format("R%03d\r", random.nextInt(1_000)).getBytes(US_ASCII));
  }

  private void addMotors() {
    add("VESC", (context, link) -> new ThrusterActuator(context, new Vesc(link, 7)), Frames::vesc);
    add(
        "RoboClaw",
        (context, link) -> new WheelMotors(context, new RoboClaw(link, 0x80, 0.1)),
        new Speaker() {
          @Override
          public byte[] frame(Random random) {
            return new byte[0];
          }

          @Override
          public byte[] answer(Random random, byte[] request) {
            return Frames.roboClaw(random, request);
          }
        });
  }

  private void addLasers() {
    add(
        "Hokuyo",
        (context, link) -> new LidarSensor(context, new Hokuyo(link)),
        new Speaker() {
          private String asked = "";

          @Override
          public byte[] frame(Random random) {
            return asked.startsWith("MD") ? Frames.scip(random, asked) : new byte[0];
          }

          @Override
          public byte[] answer(Random random, byte[] request) {
            asked = new String(request, US_ASCII).trim();
            return Frames.scip(random, asked);
          }
        });
    add(
        "RPLIDAR",
        (context, link) -> new LidarSensor(context, new Rplidar(link)),
        new Speaker() {
          @Override
          public byte[] frame(Random random) {
            return Frames.rplidar(random);
          }

          @Override
          public byte[] answer(Random random, byte[] request) {
            return switch (request[1]) {
              case 0x20 -> new byte[] {(byte) 0xA5, 0x5A, 5, 0, 0, 0x40, (byte) 0x81};
              case 0x52 -> new byte[] {(byte) 0xA5, 0x5A, 3, 0, 0, 0, 6, 0, 0, 0};
              default -> new byte[0];
            };
          }
        });
  }

  @TestFactory
  Stream<DynamicTest> step_garbageAndRandomContentUnderARightChecksum_neverThrows() {
    addMavlink();
    addNmea();
    addBinarySensors();
    addRangeFinders();
    addMotors();
    addLasers();
    return families.entrySet().stream()
        .map(each -> DynamicTest.dynamicTest(each.getKey(), () -> survives(each.getValue())));
  }

  private static byte[] garbage(Random random) {
    boolean isNoise = random.nextBoolean();
    byte[] start = isNoise ? new byte[0] : BEGINNINGS.get(random.nextInt(BEGINNINGS.size()));
    byte[] noise = new byte[random.nextInt(isNoise ? 300 : 100)];
    random.nextBytes(noise);
    byte[] chunk = Arrays.copyOf(start, start.length + noise.length);
    System.arraycopy(noise, 0, chunk, start.length, noise.length);
    return chunk;
  }

  private static void survives(Pair family) {
    Random random = new Random(20L);
    MemoryLink link = new MemoryLink();
    link.with(request -> link.fromDevice(family.device().answer(random, request)));
    try (ServiceKit kit = new ServiceKit()) {
      kit.start(context -> family.service().apply(context, link));
      kit.publish( // a radar places its targets from there
          Channels.STATE,
          new StateInformation().referenceFrame(ReferenceFrame.GLOBAL).x(8.0).y(47.0).psi(1.0));
      for (double s = 0.0; s < SECONDS; s += 0.05) {
        for (int i = 0; i < 5; i++) {
          link.fromDevice(family.device().frame(random));
        }
        kit.advance(0.05);
      }
      boolean isPublished =
          Stream.of(Channels.SENSED_STATE, Channels.SENSED_OBJECTS, Channels.SCANS, Channels.POWER)
              .anyMatch(channel -> !kit.published(channel).isEmpty());
      assertThat(isPublished).as("some readings get through").isTrue();
      for (int i = 0; i < CHUNKS; i++) {
        link.fromDevice(garbage(random));
        if (i % 500 == 499) {
          link.unplug();
        }
        kit.advance(0.02);
        link.plug();
      }
      kit.advance(1.0);
      HealthReport health = kit.latest(Channels.HEALTH).orElseThrow();
      assertThat(health.exceptions()).as("exceptions; %s", health.lastError()).isZero();
      assertThat(health.status()).isEqualTo(ServiceStatus.RUNNING);
    }
  }
}
