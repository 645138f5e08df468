package org.u2sa.device;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.u2sa.device.port.TrackingRadar;
import org.u2sa.device.port.TrafficReceiver;
import org.u2sa.device.port.TrafficTarget;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.service.ServiceContext;

/**
 * Publishes a tracking radar's targets as moving keep-out spheres, in GLOBAL, once per measurement
 * (thesis 4.4.1.3). In: state in GLOBAL, to position the targets; nothing is published before the
 * first state with a heading. Out: sensed-objects, uid {@code traffic}, the service's name and the
 * track number. A measurement without a target is published as a sphere of confidence 0, so that an
 * empty sea can be distinguished from a silent radar.
 */
public final class RadarSensor extends DeviceSensor<TrackingRadar.Tracks> {
  private static final SensorKind<TrackingRadar> KIND =
      new SensorKind<>(
          "RadarSensor",
          TrackingRadar.class,
          new Devices.Usual("radar", "RADAR", "NMEA", "serial:/dev/ttyUSB0?baud=38400"),
          Channels.SENSED_OBJECTS,
          20.0, // Hz
          10.0); // s

  private record Variables(
      @Variable(unit = "rad", min = -Math.PI, max = Math.PI, ifAbsent = 0)
          @Description("Direction of the radar's zero, from straight ahead to the left.")
          double mountedYaw,
      @Variable(unit = "m", min = 0.01, max = 10_000, ifAbsent = 30)
          @Description("Standard deviation of the range.")
          double rangeSigma,
      @Variable(unit = "rad", min = 0.0001, max = 1, ifAbsent = 0.0175)
          @Description("Standard deviation of the bearing.")
          double bearingSigma) {}

  private final Settings<Variables> tuning = settings(Variables.class);
  private final TrafficSpheres spheres = new TrafficSpheres(this, this::altitudeM);
  private Optional<StateInformation> own = Optional.empty(); // in GLOBAL, with a heading

  public RadarSensor(ServiceContext context) {
    super(context, KIND);
    subscribe(Channels.STATE, this::at);
  }

  public RadarSensor(ServiceContext context, TrackingRadar radar) {
    super(context, KIND, radar);
    subscribe(Channels.STATE, this::at);
  }

  private void at(StateInformation state) {
    if (!state.referenceFrame().isEarth()) {
      return;
    }
    StateInformation placed = state.in(ReferenceFrame.GLOBAL);
    if (placed.x().isPresent() && placed.y().isPresent() && placed.psi().isPresent()) {
      own = Optional.of(placed);
    }
  }

  private double altitudeM() {
    return own.map(state -> state.z().orElse(0.0)).orElse(0.0);
  }

  @Override
  protected Stream<MovingSphere> messages(TrackingRadar.Tracks radar) {
    return own.stream()
        .flatMap(
            state -> {
              List<TrafficTarget> targets =
                  radar.tracks().stream()
                      .map(track -> target(track, state))
                      .collect(Collectors.toList());
              if (targets.isEmpty()) {
                return Stream.of(nothing(state, radar.measuredAtMicros()));
              }
              return spheres.of(new TrafficReceiver.Traffic(radar.measuredAtMicros(), targets));
            });
  }

  private MovingSphere nothing(StateInformation state, long measuredAtMicros) {
    MovingSphere none = new MovingSphere().radius(1.0);
    none.uid("traffic " + sensorName())
        .objectType("nothing")
        .confidence(0.0)
        .referenceFrame(ReferenceFrame.GLOBAL)
        .x(state.x().getAsDouble())
        .y(state.y().getAsDouble())
        .z(altitudeM())
        .sensorName(sensorName());
    none.timestamp(measuredAtMicros);
    return none;
  }

  private TrafficTarget target(TrackingRadar.Track track, StateInformation state) {
    Geodetic here = new Geodetic(state.x().getAsDouble(), state.y().getAsDouble(), altitudeM());
    double headingRad = state.psi().getAsDouble();
    double elevationRad = track.elevationRad().orElse(0.0);
    double level = track.rangeM() * Math.cos(elevationRad);
    double bearing = trueRad(track.bearing(), headingRad);
    Geodetic place =
        here.fromEnu(
            Point.of(
                level * Math.sin(bearing),
                level * Math.cos(bearing),
                track.rangeM() * Math.sin(elevationRad)));
    Variables now = tuning.get();
    return new TrafficTarget(
        sensorName() + " " + track.id(),
        "",
        "",
        track.measuredAtMicros(),
        place.latitudeDeg(),
        place.longitudeDeg(),
        track.elevationRad().isPresent()
            ? OptionalDouble.of(place.altitudeM())
            : OptionalDouble.empty(),
        false,
        velocity(track, headingRad),
        OptionalDouble.of(Math.max(now.rangeSigma(), now.bearingSigma() * track.rangeM())));
  }

  private Optional<Point> velocity(TrackingRadar.Track track, double headingRad) {
    return track
        .course()
        .filter(course -> track.speedMps().isPresent())
        .map(course -> trueRad(course, headingRad))
        .map(
            rad ->
                Point.of(
                    track.speedMps().getAsDouble() * Math.sin(rad),
                    track.speedMps().getAsDouble() * Math.cos(rad),
                    0.0));
  }

  /** Clockwise from true north. */
  private double trueRad(TrackingRadar.Direction direction, double headingRad) {
    return direction.isTrue()
        ? direction.rad()
        : direction.rad() + headingRad - tuning.get().mountedYaw();
  }
}
