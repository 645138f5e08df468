package org.u2sa.device;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.DoubleSupplier;
import java.util.stream.Stream;
import org.u2sa.device.port.TrafficReceiver;
import org.u2sa.device.port.TrafficTarget;
import org.u2sa.device.pressure.PressureAltitude;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.service.Sensor;

/**
 * Converts reports about other traffic to moving keep-out spheres, and declares the variables of
 * their size.
 */
final class TrafficSpheres {
  private static final double UNKNOWN_ALTITUDE_SIGMA_M = 3_000.0;

  private record Variables(
      @Variable(unit = "m", min = 1, max = 100_000, ifAbsent = 150)
          @Description("Distance to keep from other traffic: radius of the published sphere.")
          double separation,
      @Variable(unit = "s", min = 0.1, max = 600, ifAbsent = 30)
          @Description("Time for which a target's velocity remains valid.")
          double horizon,
      @Variable(unit = "m", min = 0.1, max = 10_000, ifAbsent = 30)
          @Description("Standard deviation of a position, if the target reports none.")
          double positionSigma,
      @Variable(unit = "m", min = 0.1, max = 10_000, ifAbsent = 10)
          @Description(
              "Standard deviation of an altitude from one report to the next. An error common to all reports, such as of an outdated QNH, does not count: it would hide a climb or descent.")
          double altitudeSigma,
      @Variable(unit = "m/s", min = 0.01, max = 1000, ifAbsent = 2)
          @Description(
              "Standard deviation of each component of a target's velocity; slower motion is recognized later.")
          double velocitySigma,
      @Variable(unit = "Pa", min = 85_000, max = 110_000, ifAbsent = PressureAltitude.SEA_LEVEL_PA)
          @Description("Current sea-level pressure, for targets that report pressure altitudes.")
          double qnh,
      @Variable(ifAbsentText = "")
          @Description("ID of the vehicle's own transponder, which is ignored; empty: none.")
          String ownId) {}

  private final Sensor sensor;
  private final Settings<Variables> tuning;
  private final DoubleSupplier ownAltitudeM;
  private final Map<String, Long> published = new HashMap<>(); // time of each target's last report

  /**
   * Declares the variables of a sensor.
   *
   * @param ownAltitudeM altitude of the vehicle above mean sea level [m]
   */
  TrafficSpheres(Sensor sensor, DoubleSupplier ownAltitudeM) {
    this.sensor = sensor;
    tuning = sensor.settings(Variables.class);
    this.ownAltitudeM = ownAltitudeM;
  }

  /** Spheres of the targets with a new report, except the vehicle's own transponder. */
  Stream<MovingSphere> of(TrafficReceiver.Traffic traffic) {
    List<MovingSphere> news = new ArrayList<>();
    for (TrafficTarget target : traffic.targets()) {
      Long before = published.put(target.id(), target.heardAtMicros());
      boolean isNew = before == null || before != target.heardAtMicros();
      if (isNew && !target.id().equalsIgnoreCase(tuning.get().ownId())) {
        news.add(object(target));
      }
    }
    long oldest = traffic.measuredAtMicros() - Clock.micros(2.0 * 60.0);
    published.values().removeIf(heard -> heard < oldest);
    return news.stream();
  }

  private MovingSphere object(TrafficTarget target) {
    Variables now = tuning.get();
    double sigmaM = target.horizontalSigmaM().orElse(now.positionSigma());
    OptionalDouble altitudeM = altitudeM(target, now.qnh());
    MovingSphere sphere = new MovingSphere().radius(now.separation());
    sphere
        .uid("traffic " + target.id())
        .objectType(target.kind())
        .referenceFrame(ReferenceFrame.GLOBAL)
        .x(target.longitudeDeg())
        .y(target.latitudeDeg())
        .z(altitudeM.orElse(ownAltitudeM.getAsDouble()))
        .level(ObjectLevel.AVOID_ALWAYS)
        .sensorName(sensor.sensorName());
    sphere
        .motion()
        .sigma(
            Point.of(
                sigmaM,
                sigmaM,
                altitudeM.isPresent() ? now.altitudeSigma() : UNKNOWN_ALTITUDE_SIGMA_M));
    target
        .velocity()
        .ifPresent(
            velocity ->
                sphere
                    .motion()
                    .velocity(velocity)
                    .velocitySigma(now.velocitySigma())
                    .horizon(now.horizon()));
    sphere.timestamp(target.heardAtMicros());
    return sphere;
  }

  private static OptionalDouble altitudeM(TrafficTarget target, double qnhPa) {
    if (target.altitudeM().isEmpty() || !target.isPressureAltitude()) {
      return target.altitudeM();
    }
    return OptionalDouble.of(PressureAltitude.aboveSeaM(target.altitudeM().getAsDouble(), qnhPa));
  }
}
