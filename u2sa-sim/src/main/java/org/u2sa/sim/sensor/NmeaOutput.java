package org.u2sa.sim.sensor;

import java.nio.charset.StandardCharsets;
import java.time.LocalDateTime;

/** Builds one NMEA 0183 sentence, field by field. */
final class NmeaOutput {
  private static final double MINUTES = 60.0;
  private static final int NS_PER_CENTISECOND = 10_000_000;

  private final StringBuilder text = new StringBuilder(96).append('$');

  NmeaOutput(String name) {
    text.append(name);
  }

  /** Appends empty fields. */
  NmeaOutput blank(int count) {
    for (int i = 0; i < count; i++) {
      text.append(',');
    }
    return this;
  }

  NmeaOutput text(String field) {
    text.append(',').append(field);
    return this;
  }

  NmeaOutput number(double value, int digits, int decimals) {
    Decimals.append(text.append(','), value, digits, decimals);
    return this;
  }

  /** hhmmss.ss. */
  NmeaOutput timeOfDay(LocalDateTime time) {
    Decimals.append(text.append(','), time.getHour(), 2, 0);
    Decimals.append(text, time.getMinute(), 2, 0);
    Decimals.append(text, time.getSecond(), 2, 0);
    Decimals.append(
        text.append('.'),
        time.getNano() / NS_PER_CENTISECOND,
        2,
        0); // truncation never yields 60.00
    return this;
  }

  /** ddmmyy. */
  NmeaOutput date(LocalDateTime time) {
    Decimals.append(text.append(','), time.getDayOfMonth(), 2, 0);
    Decimals.append(text, time.getMonthValue(), 2, 0);
    Decimals.append(text, time.getYear() % 100, 2, 0);
    return this;
  }

  /** An angle as degrees and minutes, and its hemisphere. */
  NmeaOutput angle(
      double degrees, int digits, int minuteDecimals, String positive, String negative) {
    double scale = StrictMath.pow(10.0, minuteDecimals);
    long units = Math.round(Math.abs(degrees) * MINUTES * scale); // round before splitting
    long unitsADegree = Math.round(MINUTES * scale);
    Decimals.append(text.append(','), (double) (units / unitsADegree), digits, 0);
    Decimals.append(text, (units % unitsADegree) / scale, 2, minuteDecimals);
    return text(degrees < 0.0 ? negative : positive);
  }

  /** The sentence with checksum and line end. */
  byte[] bytes() {
    int sum = 0;
    for (int i = 1; i < text.length(); i++) {
      sum ^= text.charAt(i);
    }
    text.append('*').append(hex(sum >> 4)).append(hex(sum & 0xF)).append("\r\n");
    return text.toString().getBytes(StandardCharsets.US_ASCII);
  }

  private static char hex(int nibble) {
    return Character.toUpperCase(Character.forDigit(nibble, 16));
  }

  /** Locale-independent decimal formatting with fixed digits. */
  private static final class Decimals {
    private Decimals() {}

    /**
     * Appends a number, rounded.
     *
     * @param digits minimum digits before the point, zero-padded
     * @param decimals digits after the point, 0…9
     */
    static StringBuilder append(StringBuilder text, double value, int digits, int decimals) {
      long scale = 1;
      for (int i = 0; i < decimals; i++) {
        scale *= 10;
      }
      long scaled = Math.round(Math.abs(value) * scale);
      if (value < 0.0 && scaled > 0) {
        text.append('-');
      }
      pad(text, scaled / scale, digits);
      if (decimals > 0) {
        text.append('.');
        pad(text, scaled % scale, decimals);
      }
      return text;
    }

    private static void pad(StringBuilder text, long number, int digits) {
      String plain = Long.toString(number);
      for (int i = plain.length(); i < digits; i++) {
        text.append('0');
      }
      text.append(plain);
    }
  }
}
