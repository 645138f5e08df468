package org.u2sa.drivers.gps;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.GpsFix;

/**
 * Assembles sentences into fixes: sentences with equal times form an epoch; values without a time
 * (velocity, DOP, standard deviations) come from the latest sentence.
 */
final class NmeaEpochs {
  private static final int HOLDS_FOR_EPOCHS = 10; // some receivers send GST and GSA less often
  private static final int SURE_AFTER_EPOCHS = 2;
  private static final double STANDS_MPS = 0.5; // below this speed receivers report no course

  private final double rangeErrorM;
  private NmeaEpoch open; // null if none
  private boolean isTold; // whether the open epoch was already reported as a fix
  private NmeaEpoch.Kind closing; // learned last sentence of each epoch; null until known
  private NmeaEpoch.Kind candidate;
  private int candidateEpochs;
  private int epoch;
  private FixQuality quality = FixQuality.PLAIN;
  private Held sigmas = Held.NOTHING;
  private Held dilution = Held.NOTHING;
  private Held velocity = Held.NOTHING;
  private Optional<GpsFix> latest = Optional.empty();

  /** Two values, NaN if unknown, and their epoch. */
  private record Held(double first, double second, int since) {
    static final Held NOTHING = new Held(Double.NaN, Double.NaN, 0);
  }

  NmeaEpochs(double rangeErrorM) {
    this.rangeErrorM = rangeErrorM;
  }

  /** Adds a sentence with a position. */
  void take(NmeaEpoch said) {
    if (open != null && open.isBefore(said)) {
      close();
    }
    if (open == null) {
      open = said;
      isTold = false;
    } else {
      open.add(said);
    }
    if (open.last == closing && !isTold) {
      tell();
    }
  }

  private void close() {
    if (!isTold) {
      tell(); // the closing sentence was lost or is not known yet
    }
    candidateEpochs = open.last == candidate ? candidateEpochs + 1 : 1;
    candidate = open.last;
    if (closing == null || candidateEpochs >= SURE_AFTER_EPOCHS) {
      closing = candidate;
    }
    open = null;
    epoch++;
  }

  private void tell() {
    isTold = true;
    latest = Optional.of(open.valid ? fix(open) : GpsFix.none(open.heardMicros, open.satellites));
  }

  private GpsFix fix(NmeaEpoch said) {
    if (said.quality != quality) {
      quality = said.quality;
      if (sigmas.since < epoch) {
        sigmas = Held.NOTHING; // these belonged to a different kind of solution
      }
    }
    double speedMps = said.speedMps;
    double courseRad = said.courseRad;
    if (Double.isNaN(speedMps) && isFresh(velocity)) {
      speedMps = velocity.first;
      courseRad = velocity.second;
    }
    if (Double.isNaN(courseRad) && speedMps < STANDS_MPS) {
      speedMps = 0.0;
      courseRad = 0.0;
    }
    return new GpsFix(
        said.heardMicros,
        said.latitudeDeg,
        said.longitudeDeg,
        ifKnown(said.altitudeM),
        ifKnown(speedMps * Math.sin(courseRad)),
        ifKnown(speedMps * Math.cos(courseRad)),
        OptionalDouble.empty(),
        ifKnown(horizontalSigmaM(said)),
        ifKnown(verticalSigmaM(said)),
        said.satellites,
        true);
  }

  private double horizontalSigmaM(NmeaEpoch said) {
    if (isFresh(sigmas) && !Double.isNaN(sigmas.first)) {
      return sigmas.first;
    }
    double horizontal = isFresh(dilution) ? dilution.first : said.dilution;
    // HDOP² = EDOP² + NDOP²
    return HorizontalError.perAxisM(said.quality.rangeErrorM(rangeErrorM) * horizontal);
  }

  private double verticalSigmaM(NmeaEpoch said) {
    if (isFresh(sigmas) && !Double.isNaN(sigmas.second)) {
      return sigmas.second;
    }
    return isFresh(dilution) ? said.quality.rangeErrorM(rangeErrorM) * dilution.second : Double.NaN;
  }

  private boolean isFresh(Held held) {
    return held != Held.NOTHING && epoch - held.since <= HOLDS_FOR_EPOCHS;
  }

  private static OptionalDouble ifKnown(double value) {
    return Double.isNaN(value) ? OptionalDouble.empty() : OptionalDouble.of(value);
  }

  /** Adds standard deviations of the horizontal axes and the altitude [m]. */
  void sigmas(double horizontalM, double verticalM) {
    sigmas = new Held(horizontalM, verticalM, epoch);
  }

  /** Adds dilution of precision. */
  void dilution(double horizontal, double vertical) {
    dilution = new Held(horizontal, vertical, epoch);
  }

  /** Adds speed and course over ground [m/s, rad]. */
  void velocity(double speedMps, double courseRad) {
    velocity = new Held(speedMps, courseRad, epoch);
  }

  /** Discards an incomplete epoch and its values. */
  void reset() {
    open = null;
    sigmas = Held.NOTHING;
    dilution = Held.NOTHING;
    velocity = Held.NOTHING;
  }

  Optional<GpsFix> latest() {
    return latest;
  }
}
