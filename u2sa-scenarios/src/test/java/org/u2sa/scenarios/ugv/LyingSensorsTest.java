package org.u2sa.scenarios.ugv;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.device.GpsSensor;
import org.u2sa.device.ImuSensor;
import org.u2sa.device.port.GpsFix;
import org.u2sa.device.port.GpsReceiver;
import org.u2sa.device.port.Orientation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.ServiceContext;
import org.u2sa.sim.device.SimulatedGps;
import org.u2sa.sim.device.SimulatedImu;
import org.u2sa.sim.ground.Hazards;
import org.u2sa.sim.sensor.GpsParameters;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * User story 9: a sensor that nobody knows is added to the ground vehicle by a line in its system
 * file. One that tells the truth is used at whatever rate; one that lies is refused and named, and
 * the vehicle drives on as if it were not there.
 */
@Tag("long")
@Timeout(600)
class LyingSensorsTest {
  private static final double LIES_FROM_S = 20.0;
  private static final double ENOUGH_S = 200.0;
  private static final int LOOP = 6;
  private static final String ESTIMATOR = "  <service class=\"org.u2sa.estimation.";

  /** A sensor added, and what health is to say of it. */
  enum Added {
    GPS_20_M_OFF("GpsSensor", "", "biased|gated"),
    GPS_DRIFTS_0_2_MPS("GpsSensor", "", "biased|gated"),
    GPS_FROZEN("GpsSensor", "", "frozen"),
    GPS_EVERY_5_S("GpsSensor", "", "used"),
    COMPASS_TURNED_BY_90_DEG("CompassSensor", variable("MOUNTING ANGLE", 1.57), "biased|gated"),
    COMPASS_100_HZ("CompassSensor", variable("RATE", 100.0), "used"),
    IMU_SCALED_BY_1_5("ImuSensor", "", "biased"),
    IMU_400_HZ("ImuSensor", variable("RATE", 400.0), "used");

    private final String service;
    private final String variables;
    private final String standing;

    Added(String service, String variables, String standing) {
      this.service = service;
      this.variables = variables;
      this.standing = standing;
    }
  }

  private static final String NAME = "Xyzzy 7";
  private static final VehicleTruth AT_REST =
      new VehicleTruth(
          0.0, Point.ORIGIN, new Attitude(0.0, 0.0, 0.0), Point.ORIGIN, Point.ORIGIN, Point.ORIGIN);

  @TempDir private Path directory;

  private static String variable(String name, double value) {
    return "<variable name=\"" + name + "\" type=\"double\" value=\"" + value + "\"/>";
  }

  private Path system(Added added) throws IOException {
    Path config = UgvDrive.config();
    String own =
        "<configuration><variable name=\"SERVICE NAME\" type=\"string\" value=\"Xyzzy 7\"/>"
            + added.variables
            + "</configuration>";
    Path file = Files.writeString(directory.resolve("added.xml"), own, UTF_8);
    String line =
        "  <service class=\"org.u2sa.device." + added.service + "\" configuration=\"" + file;
    String base =
        Files.readString(config.resolve("system.xml"), UTF_8)
            .replace("configuration=\"", "configuration=\"" + config + "/");
    return Files.writeString(
        directory.resolve("system.xml"),
        base.replace(ESTIMATOR, line + "\"/>\n" + ESTIMATOR),
        UTF_8);
  }

  private static VehicleTruth moved(VehicleTruth t, double eastM) {
    Point at = Point.of(t.position().x() + eastM, t.position().y(), t.position().z());
    return new VehicleTruth(t.timeS(), at, t.attitude(), t.velocity(), t.rates(), t.acceleration());
  }

  private static VehicleTruth lied(Added added, VehicleTruth truth) {
    double since = Math.max(0.0, truth.timeS() - LIES_FROM_S);
    if (added == Added.GPS_20_M_OFF && since > 0.0) {
      return moved(truth, 20.0);
    }
    return added == Added.GPS_DRIFTS_0_2_MPS ? moved(truth, 0.2 * since) : truth;
  }

  /** A receiver at the vehicle, which is there when it is first read. */
  private static final class AddedReceiver implements GpsReceiver {
    private final Added added;
    private final UgvDrive[] drive;
    private SimulatedGps device;
    private GpsFix last;

    AddedReceiver(Added added, UgvDrive[] drive) {
      this.added = added;
      this.drive = drive;
    }

    private VehicleTruth truth() {
      return drive[0].vehicle.truth();
    }

    @Override
    public Optional<GpsFix> read(long nowMicros) {
      if (drive[0] == null) {
        return Optional.empty();
      }
      if (device == null) {
        double rateHz = added == Added.GPS_EVERY_5_S ? 0.2 : 10.0;
        device =
            new SimulatedGps(
                new GpsParameters(rateHz, 0.0, 0.016, 0.012, 60.0, 1.5, 0.03, 0.0, 1.0, 16, 4),
                drive[0].vehicle.world().plane(),
                new NoiseStreams(77),
                () -> lied(added, truth()),
                () -> false);
      }
      Optional<GpsFix> fix = device.read(nowMicros);
      if (added == Added.GPS_FROZEN && truth().timeS() > LIES_FROM_S) {
        return fix.map(each -> at(each.measuredAtMicros(), last));
      }
      last = fix.orElse(last);
      return fix;
    }

    private static GpsFix at(long micros, GpsFix f) {
      return new GpsFix(
          micros,
          f.latitudeDeg(),
          f.longitudeDeg(),
          f.altitudeM(),
          f.eastMps(),
          f.northMps(),
          f.upMps(),
          f.horizontalSigmaM(),
          f.verticalSigmaM(),
          f.satellites(),
          f.valid());
    }
  }

  private static Orientation reading(UgvDrive[] drive, double scale) {
    if (drive[0] == null) {
      return SimulatedImu.readingOf(AT_REST);
    }
    Orientation o = SimulatedImu.readingOf(drive[0].vehicle.truth());
    return new Orientation(
        o.measuredAtMicros(),
        o.rollRad(),
        o.pitchRad(),
        o.heading(),
        scale * o.xRateRadPerS(),
        scale * o.yRateRadPerS(),
        scale * o.zRateRadPerS(),
        o.specificForce());
  }

  private static ImuSensor imu(Added added, ServiceContext context, UgvDrive[] drive) {
    boolean isAdded =
        context.configuration().enumerateFields().stream()
            .anyMatch(each -> NAME.equals(each.getValue()));
    double scale = isAdded && added == Added.IMU_SCALED_BY_1_5 ? 1.5 : 1.0;
    SimulatedImu.Errors usual = SimulatedImu.Errors.vn100();
    SimulatedImu.Errors errors =
        new SimulatedImu.Errors(
            isAdded && added == Added.IMU_400_HZ ? 400.0 : usual.rateHz(),
            usual.attitudeRad(),
            usual.headingRad(),
            usual.rateRadPerS(),
            usual.biasRadPerS(),
            usual.forceMps2(),
            usual.biasMps2());
    NoiseStreams streams = new NoiseStreams(isAdded ? 78 : 79);
    return new ImuSensor(context, new SimulatedImu(errors, streams, () -> reading(drive, scale)));
  }

  private static void attach(Added added, LaunchOptions options, UgvDrive[] drive) {
    options.making(GpsSensor.class, c -> new GpsSensor(c, new AddedReceiver(added, drive)));
    if (added.service.equals("ImuSensor")) {
      options.making(ImuSensor.class, context -> imu(added, context, drive));
    }
  }

  @ParameterizedTest
  @EnumSource(Added.class)
  void drive_sensorAdded_isUsedOrRefusedAndNamed(Added added) throws Exception {
    UgvDrive[] there = new UgvDrive[1];
    UgvDrive.Scene scene = new UgvDrive.Scene(1, GpsGrade.SURVEY, Hazards.none(), List.of());
    try (UgvDrive drive =
        new UgvDrive(
            directory.resolve("logs"),
            system(added),
            scene,
            true,
            options -> attach(added, options, there))) {
      there[0] = drive;
      List<String> remarks = new ArrayList<>();
      drive.driveUntil("lies", () -> drive.nowS() > LIES_FROM_S, ENOUGH_S);
      drive.driveUntil(
          "the loop",
          () -> {
            remarks.addAll(drive.operator.remarks("StateEstimator"));
            return drive.operator.goalsDone() == LOOP;
          },
          ENOUGH_S);
      List<String> said = remarks.stream().filter(each -> each.startsWith(NAME)).toList();
      double farthestM = Collections.max(drive.misses());
      report(added, said, farthestM);
      assertThat(said).anyMatch(each -> each.matches(NAME + "[^:]*: (" + added.standing + "),.*"));
      assertThat(farthestM).isLessThan(0.55);
    }
  }

  /** Into {@code target/ugv-lies.txt} of the module. */
  private static void report(Added added, List<String> said, double farthestM) throws IOException {
    Path folder = Files.createDirectories(Path.of("target"));
    Files.writeString(
        folder.resolve("ugv-lies.txt"),
        String.format(
            Locale.ROOT,
            "| %s | %s | %.2f m |%n",
            added,
            said.isEmpty() ? "" : said.get(said.size() - 1),
            farthestM),
        StandardOpenOption.CREATE,
        StandardOpenOption.APPEND);
  }
}
