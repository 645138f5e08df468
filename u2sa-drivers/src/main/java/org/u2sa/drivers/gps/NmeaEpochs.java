package org.u2sa.drivers.gps;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.GpsFix;

/**
 * Puts a receiver's sentences together to fixes: those that name the same time belong together;
 * what names no time (velocity, dilution, standard deviations) is taken from the latest that came.
 */
final class NmeaEpochs {
  private static final int HOLDS_FOR_EPOCHS = 10; // some send GST and GSA less often
  private static final int SURE_AFTER_EPOCHS = 2;
  private static final double STANDS_MPS = 0.5; // slower than that, receivers say no course

  private final double rangeErrorM;
  private NmeaEpoch open; // null: none
  private boolean isTold; // the open one was made a fix already
  private NmeaEpoch.Kind closing; // the last sentence of each epoch, as learned; null: not yet
  private NmeaEpoch.Kind candidate;
  private int candidateEpochs;
  private int epoch;
  private FixQuality quality = FixQuality.PLAIN;
  private Held sigmas = Held.NOTHING;
  private Held dilution = Held.NOTHING;
  private Held velocity = Held.NOTHING;
  private Optional<GpsFix> latest = Optional.empty();

  /** Two numbers, NaN if unknown, and the epoch in which they came. */
  private record Held(double first, double second, int since) {
    static final Held NOTHING = new Held(Double.NaN, Double.NaN, 0);
  }

  NmeaEpochs(double rangeErrorM) {
    this.rangeErrorM = rangeErrorM;
  }

  /** Takes what one sentence with a position said. */
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
      tell(); // the sentence that would have closed it is lost, or not known yet
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
        sigmas = Held.NOTHING; // those of another kind of solution
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

  /** Standard deviations along each horizontal axis, and of the altitude [m]. */
  void sigmas(double horizontalM, double verticalM) {
    sigmas = new Held(horizontalM, verticalM, epoch);
  }

  /** Dilution of precision. */
  void dilution(double horizontal, double vertical) {
    dilution = new Held(horizontal, vertical, epoch);
  }

  /** Speed and course over ground [m/s, rad]. */
  void velocity(double speedMps, double courseRad) {
    velocity = new Held(speedMps, courseRad, epoch);
  }

  /** Forgets the sentences of an epoch that is not complete, and what came with it. */
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
