package org.u2sa.device;

import java.util.Optional;
import java.util.stream.Stream;
import org.u2sa.device.mapping.HeadingMapping;
import org.u2sa.device.mapping.TrueNorth;
import org.u2sa.device.port.Compass;
import org.u2sa.device.port.Heading;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.ServiceContext;

/**
 * Publishes a compass's heading, clockwise from true north, in GLOBAL (thesis 4.6.3). In: state,
 * for the magnetic declination at the vehicle's position. Out: sensed-state, once per heading.
 */
public final class CompassSensor extends DeviceSensor<Heading> {
  private static final SensorKind<Compass> KIND =
      new SensorKind<>(
          "CompassSensor",
          Compass.class,
          new Devices.Usual("compass", "COMPASS", "NMEA", "serial:/dev/ttyUSB1?baud=9600"),
          Channels.SENSED_STATE,
          50.0, // Hz
          1.5); // s

  private record Variables(
      @Variable(unit = "s", min = 0, max = 5, ifAbsent = 0)
          @Description(
              "Latency from measurement to arrival of a heading, from the data sheet; states are timestamped with the time of measurement.")
          double delay,
      @Variable(unit = "rad", min = -Math.PI, max = Math.PI, ifAbsent = 0)
          @Description("Yaw of the compass on the vehicle, clockwise.")
          double mountingAngle,
      @Variable(unit = "rad", min = 0, max = Math.PI, ifAbsent = Math.PI / 180)
          @Description("Standard deviation of the heading, from the data sheet.")
          double headingSigma) {}

  private final HeadingMapping headings = headings(settings(Variables.class).get());
  private boolean isWaitReported;

  public CompassSensor(ServiceContext context) {
    super(context, KIND);
  }

  public CompassSensor(ServiceContext context, Compass compass) {
    super(context, KIND, compass);
  }

  private HeadingMapping headings(Variables tuning) {
    return new HeadingMapping(
        sensorName(),
        new TrueNorth(this, clock()),
        tuning.mountingAngle(),
        tuning.headingSigma(),
        tuning.delay());
  }

  @Override
  protected Stream<StateInformation> messages(Heading heading) {
    Optional<StateInformation> state = headings.state(heading);
    if (state.isEmpty() && !isWaitReported) {
      isWaitReported = true;
      trouble(
          "no heading is published: true north is unknown until the vehicle's position is known");
    }
    return state.stream();
  }
}
