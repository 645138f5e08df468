package org.u2sa.device;

import java.util.stream.Stream;
import org.u2sa.device.port.LaserScanner;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.RangeScan;
import org.u2sa.service.ServiceContext;

/**
 * Publishes the scans of a lidar, including beams without an echo, with its mounting on the vehicle
 * (thesis 3.2.3.6, 4.1.1.1). Out: scans.
 */
public final class LidarSensor extends DeviceSensor<LaserScanner.Scan> {
  private static final SensorKind<LaserScanner> KIND =
      new SensorKind<>(
          "LidarSensor",
          LaserScanner.class,
          new Devices.Usual(
              "laser",
              "LIDAR",
              "rplidar",
              "serial:/dev/ttyUSB0?baud=115200&dtr=off"), // RPLIDAR A1 with USB adapter
          Channels.SCANS,
          100.0, // Hz
          1.0); // s

  private record Variables(
      @Variable(min = 1, max = 1000, ifAbsent = 1) @Description("Publish every Nth scan.")
          int publishEvery,
      @Variable(unit = "m", min = 0, max = 100, ifAbsent = 0.1)
          @Description("Minimum range of the scans: closer echoes are from the vehicle itself.")
          double nearest,
      @Variable(unit = "m", min = 0.1, max = 1000, ifAbsent = 100)
          @Description("Maximum range of the scans: farther echoes are ignored.")
          double farthest) {}

  private final MountingPose mounted = settings(MountingPose.class).get();
  private final Settings<Variables> tuning = settings(Variables.class);
  private long scans;

  public LidarSensor(ServiceContext context) {
    super(context, KIND);
  }

  public LidarSensor(ServiceContext context, LaserScanner scanner) {
    super(context, KIND, scanner);
  }

  @Override
  protected Stream<RangeScan> messages(LaserScanner.Scan reading) {
    if (scans++ % tuning.get().publishEvery() != 0) {
      return Stream.empty();
    }
    RangeScan scan = reading.beams();
    return Stream.of(
        mounted
            .placing(scan.sensorName(sensorName()))
            .minRange(Math.max(scan.minRange(), tuning.get().nearest()))
            .maxRange(Math.min(scan.maxRange(), tuning.get().farthest())));
  }
}
