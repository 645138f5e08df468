package org.u2sa.sim.file;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.u2sa.device.detection.ObjectDetector;
import org.u2sa.device.payload.Gimbal;
import org.u2sa.device.payload.HydrophoneArray;
import org.u2sa.device.payload.LoadCell;
import org.u2sa.device.payload.SwitchOutput;
import org.u2sa.device.port.Anemometer;
import org.u2sa.device.port.Barometer;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.Compass;
import org.u2sa.device.port.DepthGauge;
import org.u2sa.device.port.Device;
import org.u2sa.device.port.GpsReceiver;
import org.u2sa.device.port.Imu;
import org.u2sa.device.port.LaserScanner;
import org.u2sa.device.port.PitotTube;
import org.u2sa.device.port.PointScanner;
import org.u2sa.device.port.RangeFinder;
import org.u2sa.device.port.Servo;
import org.u2sa.device.port.Sonar;
import org.u2sa.device.port.TrackingRadar;
import org.u2sa.device.port.TrafficReceiver;
import org.u2sa.device.port.VelocityLog;
import org.u2sa.device.port.WheelEncoder;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.file.element.FileElement;

/** The kinds of sensors in vehicle files, one for each port of devices. */
final class SensorKinds {
  /**
   * A sensor as read by its kind.
   *
   * @param variables values of the services' variables that it determines
   * @param place its position, if State Estimators need to know it: forward, right, down [m]
   */
  record Reader(Map<String, Double> variables, Point place, SensorEntry.Maker maker) {
    Reader(Map<String, Double> variables, SensorEntry.Maker maker) {
      this(variables, Point.ORIGIN, maker);
    }

    Reader(SensorEntry.Maker maker) {
      this(Map.of(), maker);
    }
  }

  private record Kind(
      Class<? extends Device<?>> port, boolean isDelayed, Function<FileElement, Reader> reader) {}

  private static final Map<String, Kind> KINDS = kinds();

  private SensorKinds() {}

  private static Map<String, Kind> kinds() {
    Map<String, Kind> kinds = new LinkedHashMap<>();
    kinds.put("gps", new Kind(GpsReceiver.class, true, StateSensors::gps));
    kinds.put("compass", new Kind(Compass.class, false, StateSensors::compass));
    kinds.put("imu", new Kind(Imu.class, false, StateSensors::imu));
    kinds.put("encoders", new Kind(WheelEncoder.class, false, StateSensors::encoders));
    kinds.put("barometer", new Kind(Barometer.class, true, StateSensors::barometer));
    kinds.put("depthGauge", new Kind(DepthGauge.class, true, StateSensors::depthGauge));
    kinds.put("pitotTube", new Kind(PitotTube.class, true, StateSensors::pitotTube));
    kinds.put("anemometer", new Kind(Anemometer.class, true, StateSensors::anemometer));
    kinds.put("velocityLog", new Kind(VelocityLog.class, true, StateSensors::velocityLog));
    kinds.put("loadCell", new Kind(LoadCell.class, true, PayloadParts::loadCell));
    kinds.put("laser", new Kind(LaserScanner.class, false, SightSensors::laser));
    kinds.put("pointScanner", new Kind(PointScanner.class, false, SightSensors::pointScanner));
    kinds.put("sonar", new Kind(Sonar.class, false, SightSensors::sonar));
    kinds.put("hydrophones", new Kind(HydrophoneArray.class, true, SightSensors::hydrophones));
    kinds.put("rangeFinder", new Kind(RangeFinder.class, false, SightSensors::rangeFinder));
    kinds.put("detector", new Kind(ObjectDetector.class, true, SightSensors::detector));
    kinds.put("radar", new Kind(TrackingRadar.class, true, SightSensors::radar));
    kinds.put(
        "trafficReceiver", new Kind(TrafficReceiver.class, true, SightSensors::trafficReceiver));
    kinds.put("gimbal", new Kind(Gimbal.class, false, PayloadParts::gimbal));
    kinds.put("servo", new Kind(Servo.class, false, PayloadParts::servo));
    kinds.put("switch", new Kind(SwitchOutput.class, false, PayloadParts::output));
    kinds.put("camera", new Kind(Camera.class, false, SightSensors::camera));
    return kinds;
  }

  /** Whether services of a port can get their devices from vehicle files. */
  static boolean isKnown(Class<?> port) {
    return KINDS.values().stream().anyMatch(kind -> kind.port == port);
  }

  static List<SensorEntry> read(FileElement vehicle, VehicleModel model) {
    List<SensorEntry> all = new ArrayList<>();
    KINDS.forEach(
        (name, kind) -> {
          for (FileElement sensor : vehicle.parts(name, "service")) {
            SensorEntry entry = read(sensor, kind, model);
            if (all.stream()
                .anyMatch(
                    other ->
                        other.port() == entry.port() && other.service().equals(entry.service()))) {
              throw sensor
                  .xml()
                  .error(
                      entry.service().isPresent()
                          ? "service \"" + entry.service().get() + "\" already has one"
                          : "is the second one without a service; expected service=\"NAME\"");
            }
            all.add(entry);
          }
        });
    return List.copyOf(all);
  }

  private static SensorEntry read(FileElement sensor, Kind kind, VehicleModel model) {
    Optional<String> service = sensor.xml().optionalAttribute("service");
    double delay = kind.isDelayed ? 0.0 : sensor.number("delay", "s", 0.0, 5.0, 0.0);
    double lost = kind.isDelayed ? 0.0 : sensor.number("dropouts", "1", 0.0, 1.0, 0.0);
    double failsAt = sensor.number("failsAt", "s", 0.0, 1e9, Double.POSITIVE_INFINITY);
    Reader reader = sensor.made(() -> kind.reader.apply(sensor));
    Map<String, Double> variables = new LinkedHashMap<>(reader.variables());
    if (kind.port == WheelEncoder.class) {
      VehicleModel.Wheels wheels =
          model
              .wheels()
              .orElseThrow(() -> sensor.xml().error("this vehicle has no wheels with encoders"));
      variables.put("WHEEL DIAMETER", 2.0 * wheels.radiusM());
      variables.put("TRACK", wheels.trackM());
    }
    sensor.end();
    return new SensorEntry(
        sensor.xml().name(),
        kind.port,
        service,
        delay,
        lost,
        failsAt,
        variables,
        reader.place(),
        reader.maker());
  }
}
