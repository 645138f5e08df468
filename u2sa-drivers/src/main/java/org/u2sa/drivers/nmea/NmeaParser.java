package org.u2sa.drivers.nmea;

import java.util.Optional;
import org.u2sa.drivers.link.ByteParser;

/** Parses readings that fit in one NMEA 0183 sentence. */
public final class NmeaParser<R> implements ByteParser<R> {
  /** Interprets a sentence. */
  @FunctionalInterface
  public interface Meaning<R> {
    /**
     * Reading of a sentence; empty for other sentence types.
     *
     * @param nowMicros arrival time [µs, run's clock]
     * @throws IllegalArgumentException if it is malformed; the message gives the reason
     */
    Optional<R> of(NmeaSentence sentence, long nowMicros);
  }

  private final NmeaFramer framer = new NmeaFramer();
  private final NmeaFramer.Sink sink = this::take;
  private final Meaning<R> meaning;
  private Optional<R> latest = Optional.empty();
  private long nowMicros;
  private long refused;
  private String lastRefusal = "";

  /** Creates a parser with the device's interpretation. */
  public NmeaParser(Meaning<R> meaning) {
    this.meaning = meaning;
  }

  @Override
  public void accept(byte[] bytes, int length, long now) {
    nowMicros = now;
    framer.accept(bytes, length, sink);
  }

  private void take(NmeaSentence sentence) {
    try {
      Optional<R> said = meaning.of(sentence, nowMicros);
      latest = said.isPresent() ? said : latest;
    } catch (IllegalArgumentException e) { // includes NumberFormatException
      refused++;
      lastRefusal = e.getMessage() + ": " + sentence.text();
    }
  }

  @Override
  public Optional<R> latest() {
    return latest;
  }

  @Override
  public void reset() {
    framer.reset();
  }

  @Override
  public long refused() {
    return framer.refused() + refused;
  }

  @Override
  public String lastRefusal() {
    return lastRefusal.isEmpty() ? framer.lastRefusal() : lastRefusal;
  }
}
