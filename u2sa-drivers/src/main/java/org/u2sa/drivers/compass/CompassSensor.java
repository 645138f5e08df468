package org.u2sa.drivers.compass;

import java.util.Optional;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ByteLinks;
import org.u2sa.drivers.link.LinkWatch;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
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
          .describedAs("Where the compass is: " + ByteLinks.FORMS);

  static final VariableDeclaration<String> COMPASS =
      VariableDeclaration.text("COMPASS")
          .oneOf("NMEA", "SPARTON")
          .ifAbsent("NMEA")
          .describedAs(
              "NMEA: any that sends HDG, HDM or HDT by itself; SPARTON: SP3004D, DC-4, GEDC-6, AHRS-8, asked at each step.");

  static final VariableDeclaration<Double> TIMEOUT =
      VariableDeclaration.number("TIMEOUT", "s")
          .range(Range.of(0.1, 60.0))
          .ifAbsent(1.5)
          .describedAs("Time without a readable heading after which the compass counts as silent.");

  static final VariableDeclaration<Double> MOUNTING_ANGLE =
      VariableDeclaration.number("MOUNTING ANGLE", "rad")
          .range(Range.of(-Math.PI, Math.PI))
          .ifAbsent(0.0)
          .describedAs("Where the compass's front points, clockwise from the vehicle's.");

  static final VariableDeclaration<Double> HEADING_SIGMA =
      VariableDeclaration.number("HEADING SIGMA", "rad")
          .range(Range.of(0.0, Math.PI))
          .ifAbsent(Math.toRadians(1.0))
          .describedAs("Standard deviation of the heading, as the data sheet says it.");

  private final Compass compass;
  private final LinkWatch watch;
  private final TrueNorth north;
  private final double mountingRad;
  private final double sigmaRad;
  private Optional<Heading> last = Optional.empty();
  private boolean isWaitSaid;

  /** Called by the launcher: opens the link that CONNECTION names. */
  public CompassSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** With a compass that the host made: the phone's, a simulated one. */
  public CompassSensor(ServiceContext context, Compass compass) {
    this(context, Optional.of(compass));
  }

  private CompassSensor(ServiceContext context, Optional<Compass> given) {
    super(context, "CompassSensor", STEPS_PER_S);
    String address = getVariable(CONNECTION);
    boolean isSparton = getVariable(COMPASS).equals("SPARTON");
    double timeoutS = getVariable(TIMEOUT);
    mountingRad = getVariable(MOUNTING_ANGLE);
    sigmaRad = getVariable(HEADING_SIGMA);
    north = new TrueNorth(this);
    registerSubscriber(Channels.STATE);
    compass =
        given.orElseGet(
            () -> {
              ByteLink link =
                  ByteLinks.open(
                      address,
                      context.clock(),
                      path -> context.configuration().resolve(path.toString()));
              return isSparton
                  ? LinkedCompass.sparton(link)
                  : LinkedCompass.listening(link, new NmeaCompass());
            });
    watch = new LinkWatch(this, "the compass", compass, timeoutS);
  }

  @Override
  public void callback(U2SAData data) {
    if (data instanceof StateInformation state) {
      north.at(state, clock().micros());
    } else {
      unexpected(data);
    }
  }

  @Override
  protected void step(double nowS) {
    long now = clock().micros();
    watch.look(now);
    Optional<Heading> heading = compass.read(now).heading();
    watch.malformed(compass.malformed());
    if (heading.isPresent() && heading.get() != last.orElse(null)) {
      last = heading;
      watch.heard(now);
      north.of(heading.get(), -mountingRad).ifPresentOrElse(this::publish, this::sayWait);
    }
  }

  private void publish(double headingRad) {
    StateInformation state =
        new StateInformation()
            .sensorName(sensorName())
            .referenceFrame(ReferenceFrame.GLOBAL)
            .psi(headingRad)
            .psiSigma(sigmaRad);
    last.ifPresent(heading -> state.timestamp(heading.measuredAtMicros()));
    publish(Channels.SENSED_STATE, state);
  }

  private void sayWait() {
    if (!isWaitSaid) {
      isWaitSaid = true;
      trouble("true north is not known before the vehicle's position is: no heading is published");
    }
  }

  @Override
  protected void release() {
    compass.close();
  }
}
