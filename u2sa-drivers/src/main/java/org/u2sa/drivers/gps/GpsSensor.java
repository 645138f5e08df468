package org.u2sa.drivers.gps;

import java.util.Optional;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ByteLinks;
import org.u2sa.drivers.link.LinkWatch;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.service.ProprioceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * Publishes where a satellite receiver is and how it moves over ground, in GLOBAL, once for each
 * fix (thesis 4.6.3). Out: sensed-state. Nothing while the receiver has no fix, or nothing new.
 */
public final class GpsSensor extends ProprioceptiveSensor {
  private static final double STEPS_PER_S = 50.0; // a fix waits for its step 10 ms on average

  static final VariableDeclaration<String> CONNECTION =
      VariableDeclaration.text("CONNECTION")
          .ifAbsent("serial:/dev/ttyUSB0?baud=9600")
          .describedAs("Where the receiver is: " + ByteLinks.FORMS);

  static final VariableDeclaration<String> RECEIVER =
      VariableDeclaration.text("RECEIVER")
          .oneOf("NMEA", "UBLOX 6", "UBLOX 8")
          .ifAbsent("NMEA")
          .describedAs(
              "NMEA: any, only listened to; UBLOX 6: LEA-6 and older, UBLOX 8: 7 and newer, both set up at each connection.");

  static final VariableDeclaration<Double> TIMEOUT =
      VariableDeclaration.number("TIMEOUT", "s")
          .range(Range.of(0.1, 60.0))
          .ifAbsent(2.5)
          .describedAs(
              "Time without a readable message after which the receiver counts as silent.");

  static final VariableDeclaration<Double> RANGE_ERROR =
      VariableDeclaration.number("RANGE ERROR", "m")
          .range(Range.of(0.01, 100.0))
          .ifAbsent(NmeaGps.USUAL_RANGE_ERROR_M)
          .describedAs(
              "1 sigma of a distance to a satellite without corrections: times the dilution of precision it is the position's, for NMEA without GST; with DGPS and RTK the published figures count where they are less.");

  static final VariableDeclaration<Integer> BAUD =
      VariableDeclaration.integer("BAUD")
          .range(Range.of(1_200, 921_600))
          .ifAbsent(9_600)
          .describedAs(
              "Rate of a u-blox receiver's own port, as CONNECTION has it; stays as it is.");

  static final VariableDeclaration<Double> SOLUTION_RATE =
      VariableDeclaration.number("SOLUTION RATE", "Hz")
          .range(Range.of(0.1, 25.0))
          .ifAbsent(5.0)
          .describedAs("Fixes a second that a u-blox receiver is asked for.");

  private final GpsReceiver receiver;
  private final LinkWatch watch;
  private Optional<GpsFix> last = Optional.empty();
  private boolean hasFix = true; // so that one that has none from the start is said, too
  private String said = "";

  /** Called by the launcher: opens the link that CONNECTION names. */
  public GpsSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** With a receiver that the host made: the phone's, a simulated one. */
  public GpsSensor(ServiceContext context, GpsReceiver receiver) {
    this(context, Optional.of(receiver));
  }

  private GpsSensor(ServiceContext context, Optional<GpsReceiver> given) {
    super(context, "GpsSensor", STEPS_PER_S);
    String address = getVariable(CONNECTION);
    String model = getVariable(RECEIVER);
    double timeoutS = getVariable(TIMEOUT);
    double rangeErrorM = getVariable(RANGE_ERROR);
    int baud = getVariable(BAUD);
    double rateHz = getVariable(SOLUTION_RATE);
    receiver =
        given.orElseGet(
            () -> {
              ByteLink link =
                  ByteLinks.open(
                      address,
                      context.clock(),
                      path -> context.configuration().resolve(path.toString()));
              return model.equals("NMEA")
                  ? LinkedGps.listening(link, new NmeaGps(rangeErrorM))
                  : LinkedGps.ublox(
                      link, UbloxModel.valueOf(model.replace(' ', '_')), baud, rateHz);
            });
    watch = new LinkWatch(this, "the GPS receiver", receiver, timeoutS);
  }

  @Override
  protected void step(double nowS) {
    long now = clock().micros();
    watch.look(now);
    Optional<GpsFix> fix = receiver.read(now).fix();
    watch.malformed(receiver.malformed());
    sayTrouble();
    if (fix.isPresent() && fix.get() != last.orElse(null)) {
      last = fix;
      watch.heard(now);
      take(fix.get());
    }
  }

  /** Such as a refused setup: the link's own is said by the watch. */
  private void sayTrouble() {
    String trouble = receiver.isConnected() ? receiver.trouble() : "";
    if (!trouble.equals(said)) {
      said = trouble;
      if (!trouble.isEmpty()) {
        trouble(trouble);
      }
    }
  }

  private void take(GpsFix fix) {
    if (fix.valid() != hasFix) {
      hasFix = fix.valid();
      if (hasFix) {
        log("the GPS receiver has a fix");
      } else {
        trouble("the GPS receiver has no fix (" + fix.satellites() + " satellites)");
      }
    }
    if (fix.valid()) {
      publish(Channels.SENSED_STATE, FixedState.of(fix).sensorName(sensorName()));
    }
  }

  @Override
  protected void release() {
    receiver.close();
  }
}
