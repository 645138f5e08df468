package org.u2sa.drivers.nmea;

import java.util.Optional;
import org.u2sa.drivers.link.ByteParser;

/** Makes readings of NMEA 0183 sentences, for devices that say all in one sentence. */
public final class NmeaParser<R> implements ByteParser<R> {
  /** What a sentence means. */
  @FunctionalInterface
  public interface Meaning<R> {
    /**
     * The reading in a sentence; empty if the sentence is about something else.
     *
     * @param nowMicros when it arrived [µs of the run's clock]
     * @throws IllegalArgumentException if it cannot be understood; the message says why
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

  /** With what the device's sentences mean. */
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
    } catch (IllegalArgumentException e) { // NumberFormatException is one
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
