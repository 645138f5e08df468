package org.u2sa.drivers.ioio;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.drivers.gps.GpsFix;
import org.u2sa.interfaces.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * The last fix of the receiver, carried ahead by its own velocity: a compass measures many times
 * between two fixes.
 */
final class CarriedFix {
  private final long timeoutMicros;
  private Optional<GpsFix> fix = Optional.empty();

  /**
   * @param timeoutS age at which a fix says nothing any more [s]
   */
  CarriedFix(double timeoutS) {
    timeoutMicros = Clock.micros(timeoutS);
  }

  void accept(GpsFix newest) {
    if (newest.valid()) {
      fix = Optional.of(newest);
    }
  }

  /** The last fix, however old; empty before the first. */
  Optional<GpsFix> last() {
    return fix;
  }

  /** Whether there is one that is young enough. */
  boolean isFresh(long nowMicros) {
    return fix.isPresent() && nowMicros - fix.get().measuredAtMicros() <= timeoutMicros;
  }

  /** Adds where the vehicle is now, how fast and how surely; nothing if the fix is too old. */
  void addTo(StateInformation state, long nowMicros) {
    if (!isFresh(nowMicros)) {
      return;
    }
    GpsFix last = fix.get();
    double ageS = Math.max(0.0, Clock.seconds(nowMicros - last.measuredAtMicros()));
    Geodetic place =
        new Geodetic(last.longitudeDeg(), last.latitudeDeg(), last.altitudeM().orElse(0.0))
            .fromEnu(
                Point.of(
                    ageS * last.eastMps().orElse(0.0),
                    ageS * last.northMps().orElse(0.0),
                    ageS * last.upMps().orElse(0.0)));
    state.referenceFrame(ReferenceFrame.GLOBAL).x(place.longitudeDeg()).y(place.latitudeDeg());
    last.altitudeM().ifPresent(altitude -> state.z(place.altitudeM()));
    last.eastMps().ifPresent(state::xDot);
    last.northMps().ifPresent(state::yDot);
    last.upMps().ifPresent(state::zDot);
    OptionalDouble sigma = last.horizontalSigmaM();
    sigma.ifPresent(state::xSigma);
    sigma.ifPresent(state::ySigma);
    last.verticalSigmaM().ifPresent(state::zSigma);
  }
}
