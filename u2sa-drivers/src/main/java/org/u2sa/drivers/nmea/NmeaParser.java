package org.u2sa.drivers.nmea;

import java.util.Optional;
import org.u2sa.drivers.link.ByteParser;

/** Parses readings from NMEA 0183 sentences. */
public class NmeaParser<R> extends ByteParser<R> {
  /** Interprets a sentence. */
  @FunctionalInterface
  public interface Meaning<R> {
    /**
     * Reading of a sentence; empty for other sentence types.
     *
     * @param nowMicros arrival time [µs, run's clock]
     * @throws RuntimeException if it is malformed; the message gives the reason
     */
    Optional<R> of(NmeaSentence sentence, long nowMicros);
  }

  private final NmeaFramer framer = new NmeaFramer(this::take, this::refuse);
  private final Meaning<R> meaning;
  private long nowMicros;

  /** Creates a parser with the device's interpretation. */
  public NmeaParser(Meaning<R> meaning) {
    this.meaning = meaning;
  }

  @Override
  public void accept(byte[] bytes, int length, long now) {
    nowMicros = now;
    framer.accept(bytes, length);
  }

  private void take(NmeaSentence sentence) {
    try {
      meaning.of(sentence, nowMicros).ifPresent(this::found);
    } catch (RuntimeException e) { // marineapi throws various exceptions on malformed sentences
      refuse(e.getMessage() + ": " + sentence.text());
    }
  }

  @Override
  public void reset() {
    framer.reset();
  }
}
