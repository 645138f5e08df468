package org.u2sa.network;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.u2sa.testkit.ProcessTree;

/** Watches the true flight of an {@link AircraftMain}: whatever breaks, it must stay in the air. */
final class Aircraft implements AutoCloseable {
  private static final double AIRBORNE_M = 150.0;
  private static final double LOWEST_M = 50.0;
  private static final double STEEPEST_DEG = 60.0;

  private final Process process;
  private final StringBuilder track =
      new StringBuilder("timeS,longitudeDeg,latitudeDeg,heightM,airspeedMps,bankDeg,onGround\n");
  private final List<String> violations = new ArrayList<>();
  private boolean airborne;
  private double heightM;
  private double lowestM = Double.POSITIVE_INFINITY;
  private double steepestDeg;

  Aircraft(Process process) {
    this.process = process;
    Thread reader = new Thread(this::read, "truth-reader");
    reader.setDaemon(true);
    reader.start();
  }

  private void read() {
    try (BufferedReader lines =
        new BufferedReader(
            new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        look(line);
      }
    } catch (IOException e) {
      violation("was lost: " + e.getMessage());
    }
  }

  private synchronized void look(String line) {
    track.append(line).append('\n');
    String[] parts = line.split(",");
    heightM = Double.parseDouble(parts[3]);
    airborne |= heightM > AIRBORNE_M;
    if (!airborne) {
      return;
    }
    double bankDeg = Math.abs(Double.parseDouble(parts[5]));
    lowestM = Math.min(lowestM, heightM);
    steepestDeg = Math.max(steepestDeg, bankDeg);
    if (Boolean.parseBoolean(parts[6]) || heightM < LOWEST_M) {
      violation("sank to " + heightM + " m at " + parts[0] + " s");
    } else if (bankDeg > STEEPEST_DEG) {
      violation("banked " + bankDeg + " deg at " + parts[0] + " s");
    }
  }

  private synchronized void violation(String what) {
    if (violations.size() < 3) {
      violations.add(what);
    }
  }

  synchronized double heightM() {
    return heightM;
  }

  /** What the aircraft must not do and did. */
  synchronized List<String> violations() {
    return List.copyOf(violations);
  }

  synchronized String extremes() {
    return String.format(
        Locale.ROOT, "lowest %.0f m, steepest bank %.0f deg", lowestM, steepestDeg);
  }

  /** The flown track as CSV. */
  synchronized String track() {
    return track.toString();
  }

  @Override
  public void close() {
    ProcessTree.kill(process);
  }
}
