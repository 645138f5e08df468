package org.u2sa.device;

import java.util.Optional;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.ProprioceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * Publishes a compass's heading, clockwise from true north, in GLOBAL (thesis 4.6.3). In: state,
 * for the magnetic declination where the vehicle is. Out: sensed-state, once for each heading.
 */
public final class CompassSensor extends ProprioceptiveSensor {
  private static final double STEPS_PER_S = 50.0;

  static final VariableDeclaration<String> CONNECTION =
      VariableDeclaration.text("CONNECTION")
          .ifAbsent("serial:/dev/ttyUSB1?baud=9600")
          .describedAs("Address of the compass, as its driver takes it (docs/drivers/links.md).");

  static final VariableDeclaration<String> COMPASS =
      VariableDeclaration.text("COMPASS")
          .ifAbsent("NMEA")
          .describedAs("Kind of compass: the name of a driver.");

  static final VariableDeclaration<Double> TIMEOUT =
      VariableDeclaration.number("TIMEOUT", "s")
          .range(Range.of(0.1, 60.0))
          .ifAbsent(1.5)
          .describedAs("Time without a readable heading after which the compass counts as silent.");

  static final VariableDeclaration<Double> MOUNTING_ANGLE =
      VariableDeclaration.number("MOUNTING ANGLE", "rad")
          .range(Range.of(-Math.PI, Math.PI))
          .ifAbsent(0.0)
          .describedAs("Direction of the compass's front, clockwise from the vehicle's.");

  static final VariableDeclaration<Double> HEADING_SIGMA =
      VariableDeclaration.number("HEADING SIGMA", "rad")
          .range(Range.of(0.0, Math.PI))
          .ifAbsent(Math.toRadians(1.0))
          .describedAs("Standard deviation of the heading, from the data sheet.");

  private final Compass compass;
  private final HeadingReader reader;
  private boolean isWaitReported;

  /** Called by the launcher: the compass is the one that the configuration names. */
  public CompassSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** With a compass that the host made: the phone's, a simulated one. */
  public CompassSensor(ServiceContext context, Compass compass) {
    this(context, Optional.of(compass));
  }

  private CompassSensor(ServiceContext context, Optional<Compass> made) {
    super(context, "CompassSensor", STEPS_PER_S);
    getVariable(CONNECTION);
    double timeoutS = getVariable(TIMEOUT);
    double mountingRad = getVariable(MOUNTING_ANGLE);
    double sigmaRad = getVariable(HEADING_SIGMA);
    TrueNorth north = new TrueNorth(this);
    registerSubscriber(Channels.STATE);
    compass = Devices.open(Compass.class, COMPASS, context, made);
    reader = new HeadingReader(this, compass, sensorName(), timeoutS, north, mountingRad, sigmaRad);
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
      trouble("true north is not known before the vehicle's position is: no heading is published");
    }
  }

  @Override
  protected void release() {
    compass.close();
  }
}
