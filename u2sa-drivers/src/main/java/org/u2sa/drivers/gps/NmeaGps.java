package org.u2sa.drivers.gps;

import java.util.Optional;
import org.u2sa.device.port.GpsFix;
import org.u2sa.drivers.nmea.NmeaParser;

/**
 * An NMEA 0183 receiver: position from RMC and GGA, velocity from RMC or VTG, standard deviations
 * from GST, or DOP from GSA or GGA without GST.
 *
 * <p>One fix per epoch, reported with the epoch's last position sentence. Which sentence is last is
 * learned from earlier epochs, so only the first fix waits for the next epoch.
 */
public final class NmeaGps extends NmeaParser<GpsFix> {
  /** Typical range error of an uncorrected receiver under open sky [m], 1 σ. */
  public static final double USUAL_RANGE_ERROR_M = 3.0;

  private final NmeaEpochs epochs;

  /** Uses {@link #USUAL_RANGE_ERROR_M}. */
  public NmeaGps() {
    this(USUAL_RANGE_ERROR_M);
  }

  /**
   * @param rangeErrorM 1 σ range error [m]; times DOP it gives the position sigma for receivers
   *     without GST
   */
  public NmeaGps(double rangeErrorM) {
    this(new NmeaEpochs(rangeErrorM));
  }

  private NmeaGps(NmeaEpochs epochs) {
    super(new NmeaReader(epochs));
    this.epochs = epochs;
  }

  @Override
  public Optional<GpsFix> latest() {
    return epochs.latest();
  }

  @Override
  public void reset() {
    super.reset();
    epochs.reset();
  }
}
