package org.u2sa.device.wheel;

import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;

/** Speed and yaw rate of a differential vehicle from its wheel encoders (thesis 4.1.1.1). */
public final class WheelOdometry {
  // The ends of a span are each wrong by up to half a count: their difference has σ = 1/√6 counts.
  private static final double COUNT_SIGMA = 1.0 / Math.sqrt(6.0);

  private final double metresPerCount;
  private final double trackM;
  private final double slip;
  private final double fastestMps;
  private boolean hasBegun;
  private long atMicros;
  private int left;
  private int right;

  /**
   * @param metresPerCount distance a wheel travels per count [m]
   * @param trackM distance between the wheels [m]
   * @param slip standard deviation of a speed, as a fraction of it
   * @param fastestMps maximum plausible speed [m/s]; above it, the controller has restarted its
   *     counts
   */
  WheelOdometry(double metresPerCount, double trackM, double slip, double fastestMps) {
    this.metresPerCount = metresPerCount;
    this.trackM = trackM;
    this.slip = slip;
    this.fastestMps = fastestMps;
  }

  /** Discards the last counts; the next reading starts a new interval. */
  public void reset() {
    hasBegun = false;
  }

  /**
   * The motion since the last call, in BODY: forward speed, zero lateral speed, yaw rate (left
   * positive); averaged, at the midpoint between the two calls. Empty at the first call, if no time
   * has passed, and for implausible jumps.
   *
   * @param leftCounts forward positive; wraps at 32 bits
   * @param rightCounts likewise
   */
  public Optional<StateInformation> moved(long nowMicros, int leftCounts, int rightCounts) {
    double seconds = Clock.seconds(nowMicros - atMicros);
    double leftMps = (leftCounts - left) * metresPerCount / seconds;
    double rightMps = (rightCounts - right) * metresPerCount / seconds;
    long middleMicros = nowMicros - (nowMicros - atMicros) / 2;
    boolean isSpan = hasBegun && seconds > 0.0;
    hasBegun = true;
    atMicros = nowMicros;
    left = leftCounts;
    right = rightCounts;
    if (!isSpan || Math.abs(leftMps) > fastestMps || Math.abs(rightMps) > fastestMps) {
      return Optional.empty();
    }
    double forwardMps = (leftMps + rightMps) / 2.0;
    double countMps = COUNT_SIGMA * metresPerCount / seconds;
    double sigmaMps = Math.hypot(countMps, slip * Math.max(Math.abs(leftMps), Math.abs(rightMps)));
    StateInformation state =
        new StateInformation()
            .referenceFrame(ReferenceFrame.BODY)
            .xDot(forwardMps)
            .yDot(0.0)
            .psiDot((rightMps - leftMps) / trackM)
            .xDotSigma(sigmaMps / Math.sqrt(2.0))
            .yDotSigma(sigmaMps)
            .psiDotSigma(sigmaMps * Math.sqrt(2.0) / trackM);
    state.timestamp(middleMicros);
    return Optional.of(state);
  }
}
