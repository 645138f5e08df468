package org.u2sa.device;

import java.util.Optional;
import org.u2sa.device.port.Compass;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.ProprioceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * Publishes a compass's heading, clockwise from true north, in GLOBAL (thesis 4.6.3). In: state,
 * for the magnetic declination at the vehicle's position. Out: sensed-state, once per heading.
 */
public final class CompassSensor extends ProprioceptiveSensor {
  private static final double STEPS_PER_S = 50.0;

  private static final Devices.Usual USUAL =
      new Devices.Usual("compass", "COMPASS", "NMEA", "serial:/dev/ttyUSB1?baud=9600");

  private record Tuning(
      @Variable(
              unit = "s",
              min = 0.1,
              max = 60,
              ifAbsent = 1.5,
              text = "Time without a readable heading after which the compass counts as silent.")
          double timeout,
      @Variable(
              unit = "s",
              min = 0,
              max = 5,
              ifAbsent = 0,
              text =
                  "Time from the moment that a heading is of to its arrival, from the data sheet; states get that moment's timestamp.")
          double delay,
      @Variable(
              unit = "rad",
              min = -Math.PI,
              max = Math.PI,
              ifAbsent = 0,
              text = "Direction of the compass's front, clockwise from the vehicle's.")
          double mountingAngle,
      @Variable(
              unit = "rad",
              min = 0,
              max = Math.PI,
              ifAbsent = Math.PI / 180,
              text = "Standard deviation of the heading, from the data sheet.")
          double headingSigma) {}

  private final Compass compass;
  private final HeadingReader reader;
  private boolean isWaitReported;

  /** Launcher constructor: opens the configured compass. */
  public CompassSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** Uses the given compass, e.g. the phone's or a simulated one. */
  public CompassSensor(ServiceContext context, Compass compass) {
    this(context, Optional.of(compass));
  }

  private CompassSensor(ServiceContext context, Optional<Compass> made) {
    super(context, "CompassSensor", STEPS_PER_S);
    Tuning tuning = settings(Tuning.class).get();
    TrueNorth north = new TrueNorth(this);
    registerSubscriber(Channels.STATE);
    compass = Devices.open(Compass.class, USUAL, context, made);
    reader =
        new HeadingReader(
            this,
            compass,
            sensorName(),
            tuning.timeout(),
            north,
            tuning.mountingAngle(),
            tuning.headingSigma(),
            tuning.delay());
  }

  @Override
  public void callback(U2SAData data) {
    if (data instanceof StateInformation state) {
      reader.at(state, clock().micros());
    } else {
      unexpected(data);
    }
  }

  @Override
  protected void step(double nowS) {
    reader.next(clock().micros()).ifPresent(state -> publish(Channels.SENSED_STATE, state));
    if (reader.waitsForPosition() && !isWaitReported) {
      isWaitReported = true;
      trouble(
          "no heading is published: true north is unknown until the vehicle's position is known");
    }
  }

  @Override
  protected void release() {
    compass.close();
  }
}
