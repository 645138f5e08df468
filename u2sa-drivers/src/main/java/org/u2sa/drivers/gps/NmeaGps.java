package org.u2sa.drivers.gps;

import java.util.Optional;
import org.u2sa.device.GpsFix;
import org.u2sa.drivers.link.ByteParser;
import org.u2sa.drivers.nmea.NmeaFramer;
import org.u2sa.drivers.nmea.NmeaSentence;

/**
 * A receiver that speaks NMEA 0183: RMC and GGA give the position, RMC or VTG the velocity, GST the
 * standard deviations, GSA or GGA the dilution of precision where there is no GST.
 *
 * <p>One fix for each time that the receiver names. It is made when the last sentence with a
 * position of that time is there; which one that is, is learned from the times before, so that only
 * the very first fix has to wait for the next time.
 */
public final class NmeaGps implements ByteParser<GpsFix> {
  /** Error of the distance to a satellite [m], 1 σ, that a plain receiver has under open sky. */
  public static final double USUAL_RANGE_ERROR_M = 3.0;

  private final NmeaFramer framer = new NmeaFramer();
  private final NmeaEpochs epochs;
  private final NmeaReader reader;
  private final NmeaFramer.Sink sink = this::take;
  private long nowMicros;

  /** With {@link #USUAL_RANGE_ERROR_M}. */
  public NmeaGps() {
    this(USUAL_RANGE_ERROR_M);
  }

  /**
   * @param rangeErrorM standard deviation of the distance to a satellite [m]: times the dilution of
   *     precision it is that of the position, for receivers that do not send GST
   */
  public NmeaGps(double rangeErrorM) {
    epochs = new NmeaEpochs(rangeErrorM);
    reader = new NmeaReader(epochs);
  }

  @Override
  public void accept(byte[] bytes, int length, long now) {
    nowMicros = now;
    framer.accept(bytes, length, sink);
  }

  private void take(NmeaSentence sentence) {
    reader.read(sentence, nowMicros);
  }

  @Override
  public Optional<GpsFix> latest() {
    return epochs.latest();
  }

  @Override
  public void reset() {
    framer.reset();
    epochs.reset();
  }

  @Override
  public long refused() {
    return framer.refused() + reader.refused();
  }

  @Override
  public String lastRefusal() {
    return reader.lastRefusal().isEmpty() ? framer.lastRefusal() : reader.lastRefusal();
  }
}
