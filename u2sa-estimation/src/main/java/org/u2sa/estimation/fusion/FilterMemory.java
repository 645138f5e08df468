package org.u2sa.estimation.fusion;

import java.util.Optional;
import java.util.StringJoiner;
import java.util.function.BiConsumer;
import java.util.function.Function;

/**
 * Serialises a filter's state as text and restores it, so that another filter of the same version
 * resumes where it left off. Numbers are exact (hexadecimal doubles); only half of the symmetric
 * covariance is stored. Source statistics are not stored but learned again.
 */
public final class FilterMemory {
  private static final String NOMINAL = "FILTER NOMINAL 4";
  private static final String COVARIANCE = "FILTER COVARIANCE 5";
  private static final String FLAGS = "FILTER FLAGS 3";

  private static final String PERSISTENT = "FILTER PERSISTENT ERRORS OF ";
  private static final String DELAY = "FILTER DELAY OF ";

  private static final int N = FilterState.N;
  private static final int HALF = N * (N + 1) / 2;

  private FilterMemory() {}

  /** Writes the texts, each under its key. */
  public static void write(ErrorStateFilter filter, BiConsumer<String, String> to) {
    FilterState s = filter.state();
    if (!s.isStarted) {
      return;
    }
    to.accept(NOMINAL, text(s.x));
    to.accept(COVARIANCE, text(half(s.p.data)));
    StringJoiner flags = new StringJoiner(" ");
    for (boolean flag :
        new boolean[] {s.hasPlace, s.hasAltitude, s.hasLocal, s.hasHeading, s.hasTilt, s.hasFlow}) {
      flags.add(flag ? "1" : "0");
    }
    flags.add(Long.toString(s.micros)).add(Long.toString(s.startedMicros));
    to.accept(FLAGS, flags.toString());
    names(filter, PERSISTENT, s.persistentSource, to);
    names(filter, DELAY, s.delaySource, to);
  }

  private static void names(
      ErrorStateFilter filter, String of, int[] sources, BiConsumer<String, String> to) {
    for (int slot = 0; slot < sources.length; slot++) {
      if (sources[slot] >= 0) {
        to.accept(of + slot, filter.trust().name(sources[slot]));
      }
    }
  }

  /** Lower triangle of a symmetric matrix, row by row. */
  private static double[] half(double[] p) {
    double[] half = new double[HALF];
    int at = 0;
    for (int row = 0; row < N; row++) {
      System.arraycopy(p, row * N, half, at, row + 1);
      at += row + 1;
    }
    return half;
  }

  private static void unfold(double[] half, double[] p) {
    int at = 0;
    for (int row = 0; row < N; row++) {
      for (int column = 0; column <= row; column++) {
        p[row * N + column] = half[at];
        p[column * N + row] = half[at];
        at++;
      }
    }
  }

  private static String text(double[] numbers) {
    StringJoiner text = new StringJoiner(" ");
    for (double number : numbers) {
      text.add(Double.toHexString(number));
    }
    return text.toString();
  }

  /**
   * Restores the texts into a new filter.
   *
   * @return false if absent or of another version
   * @throws IllegalArgumentException if the texts are damaged
   */
  public static boolean read(ErrorStateFilter filter, Function<String, Optional<String>> from) {
    Optional<String> nominal = from.apply(NOMINAL);
    Optional<String> covariance = from.apply(COVARIANCE);
    Optional<String> flags = from.apply(FLAGS);
    if (nominal.isEmpty() || covariance.isEmpty() || flags.isEmpty()) {
      return false;
    }
    FilterState s = new FilterState();
    fill(NOMINAL, nominal.get(), s.x);
    double[] half = new double[HALF];
    fill(COVARIANCE, covariance.get(), half);
    unfold(half, s.p.data);
    String[] parts = flags.get().split(" ");
    if (parts.length != 8) {
      throw new IllegalArgumentException(FLAGS + ": " + parts.length + " values, expected 8");
    }
    s.isStarted = true;
    s.gyroSource = FilterState.RESUMED;
    s.hasPlace = "1".equals(parts[0]);
    s.hasAltitude = "1".equals(parts[1]);
    s.hasLocal = "1".equals(parts[2]);
    s.hasHeading = "1".equals(parts[3]);
    s.hasTilt = "1".equals(parts[4]);
    s.hasFlow = "1".equals(parts[5]);
    s.micros = Long.parseLong(parts[6]);
    s.startedMicros = Long.parseLong(parts[7]);
    sources(filter, PERSISTENT, s.persistentSource, from);
    sources(filter, DELAY, s.delaySource, from);
    s.positionMicros = s.micros;
    s.velocityMicros = s.micros;
    filter.resume(s);
    return true;
  }

  private static void sources(
      ErrorStateFilter filter, String of, int[] to, Function<String, Optional<String>> from) {
    for (int slot = 0; slot < to.length; slot++) {
      Optional<String> source = from.apply(of + slot);
      to[slot] = source.map(filter.trust()::source).orElse(FilterState.NO_SOURCE);
    }
  }

  private static void fill(String name, String text, double[] to) {
    String[] parts = text.split(" ");
    if (parts.length != to.length) {
      throw new IllegalArgumentException(
          name + ": " + parts.length + " numbers, expected " + to.length);
    }
    for (int i = 0; i < to.length; i++) {
      to[i] = Double.parseDouble(parts[i]);
    }
  }
}
