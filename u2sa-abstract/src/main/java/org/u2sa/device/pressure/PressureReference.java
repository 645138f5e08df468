package org.u2sa.device.pressure;

import java.util.Locale;
import java.util.function.Consumer;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.GroundPressure;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * The sea-level pressure from which a barometer's altitudes are computed (thesis 4.4.1.2): the
 * ground station's value or, without one, the configured value. It is checked against the state's
 * altitude where that is reliable; a contradicting value is replaced by a fitted one.
 */
public final class PressureReference {
  private static final double LOWEST_PA = 85_000.0;
  private static final double HIGHEST_PA = 110_000.0;
  private static final double SURE_M = 10.0; // maximum sigma of an altitude to compare with
  private static final double FRESH_S = 1.0;
  private static final double COMPARES_S = 10.0;
  private static final double OLDEST_S = 3_600.0; // weather changes by about 1 hPa an hour
  private static final double TOLD_SIGMA_M = 5.0; // weather and the station's instrument
  private static final double FITTED_SIGMA_M = 10.0; // errors of the receiver

  private final Consumer<String> trouble;
  private double toleranceM = Double.POSITIVE_INFINITY;
  private double configuredPa = Double.NaN;
  private double qnhPa = Double.NaN;
  private String source = "";
  private double sigmaM; // 0: as configured
  private double stateM; // altitude of the newest reliable state
  private long stateMicros = Long.MIN_VALUE / 2;
  private double newestPa = Double.NaN;
  private double sumM; // of differences from the state
  private int count;
  private long since;

  /**
   * @param trouble receives messages for the operator
   */
  public PressureReference(Consumer<String> trouble) {
    this.trouble = trouble;
  }

  /** Sets the configured pressure at sea level [Pa]; a change takes effect at once. */
  public void configure(double pascals) {
    if (pascals != configuredPa) {
      configuredPa = pascals;
      adopt(pascals, "configured; no station sent one", 0.0);
    }
  }

  private void adopt(double pascals, String from, double sigma) {
    qnhPa = pascals;
    source = from;
    sigmaM = sigma;
    count = 0;
    sumM = 0.0;
  }

  /** Uses a ground station's value unless it is old or contradicts a reliable altitude. */
  public void hear(GroundPressure told, long nowMicros) {
    double pascals = PressureAltitude.qnhOf(told.pressure(), told.z().orElse(0.0));
    String what = hectopascals(pascals) + " from " + told.operator();
    double ageS = Clock.seconds(nowMicros - told.timestamp().orElse(nowMicros));
    boolean comparable = isSure(nowMicros) && !Double.isNaN(newestPa);
    double offM = comparable ? PressureAltitude.altitudeM(newestPa, pascals) - stateM : Double.NaN;
    if (!(pascals >= LOWEST_PA && pascals <= HIGHEST_PA)) {
      trouble.accept("QNH " + what + " is refused: expected 850…1100 hPa");
    } else if (ageS > OLDEST_S) {
      trouble.accept("QNH " + what + " is refused: it is older than an hour");
    } else if (Math.abs(offM) > toleranceM) {
      trouble.accept(
          String.format(
              Locale.ROOT, "QNH %s is refused: it contradicts the altitude by %.0f m", what, offM));
    } else {
      adopt(pascals, "from " + told.operator(), TOLD_SIGMA_M);
    }
  }

  /** Sets the difference from a reliable altitude at which a pressure counts as wrong [m]. */
  public void tolerate(double metres) {
    toleranceM = metres;
  }

  private boolean isSure(long nowMicros) {
    return Math.abs(nowMicros - stateMicros) <= Clock.micros(FRESH_S);
  }

  /** Records the altitude of a state if it is reliable. */
  public void see(StateInformation state) {
    boolean isSure =
        state.referenceFrame().equals(ReferenceFrame.GLOBAL)
            && state.z().isPresent()
            && state.zSigma().orElse(Double.POSITIVE_INFINITY) <= SURE_M;
    if (isSure) {
      stateM = state.z().getAsDouble();
      stateMicros = state.timestamp().orElse(Long.MIN_VALUE / 2);
    }
  }

  /** Altitude above mean sea level of a pressure [m]. */
  public double altitudeM(double pascals, long micros) {
    newestPa = pascals;
    double altitude = PressureAltitude.altitudeM(pascals, qnhPa);
    if (!isSure(micros)) {
      count = 0;
      sumM = 0.0;
      return altitude;
    }
    since = count == 0 ? micros : since;
    sumM += altitude - stateM;
    count++;
    double offM = sumM / count;
    if (micros - since < Clock.micros(COMPARES_S)) {
      return altitude;
    }
    count = 0;
    sumM = 0.0;
    if (Math.abs(offM) <= toleranceM) {
      return altitude;
    }
    double fits = PressureAltitude.qnhOf(pascals, altitude - offM);
    trouble.accept(
        String.format(
            Locale.ROOT,
            "QNH %s, %s, contradicts the altitude by %.0f m; using %s, which fits",
            hectopascals(qnhPa),
            source,
            offM,
            hectopascals(fits)));
    adopt(fits, "fitted to the altitude", FITTED_SIGMA_M);
    return altitude - offM;
  }

  /** Standard deviation of an altitude [m]. */
  public double sigmaM(double configuredM) {
    return sigmaM == 0.0 ? configuredM : sigmaM;
  }

  private static String hectopascals(double pascals) {
    return String.format(Locale.ROOT, "%.1f hPa", pascals / 100.0);
  }

  @Override
  public String toString() {
    return hectopascals(qnhPa) + ", " + source;
  }
}
