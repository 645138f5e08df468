package org.u2sa.drivers.range;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.util.function.DoubleUnaryOperator;
import java.util.function.LongSupplier;
import org.u2sa.drivers.link.MemoryLink;

/**
 * A Hokuyo UST-10LX, byte for byte as SCIP 2 says: 1081 steps of a quarter of a degree, 40 turns a
 * second. Written apart from the driver.
 */
final class SimulatedHokuyo {
  private static final int STEPS = 1081;
  private static final int FRONT = 540;
  private static final long PERIOD_MICROS = 25_000;

  private final MemoryLink link;
  private final LongSupplier clock;
  private final DoubleUnaryOperator world; // degrees to the left -> metres
  private final StringBuilder request = new StringBuilder();
  private boolean lit;
  private String measures = ""; // the command that is being carried out
  private long dueMicros;
  private boolean mute;
  private boolean wrongSums;
  private boolean broken;
  private boolean isScip1; // as a URG-04LX wakes up
  private boolean wakesUpWithScip1;

  SimulatedHokuyo(MemoryLink link, LongSupplier clock, DoubleUnaryOperator world) {
    this.link = link;
    this.clock = clock;
    this.world = world;
    link.with(this::accept).producing(this::produce);
  }

  void mute(boolean isMute) {
    mute = isMute;
  }

  void wrongSums(boolean areWrong) {
    wrongSums = areWrong;
  }

  /** Laser or motor: measuring is refused with status 50. */
  void broken(boolean isBroken) {
    broken = isBroken;
    measures = isBroken ? "" : measures;
  }

  /** It gets power: one that wakes up with SCIP 1.1 has to be told again. */
  void powerOn(boolean withScip1) {
    wakesUpWithScip1 = withScip1;
    isScip1 = withScip1;
    lit = false;
    measures = "";
  }

  boolean isScip1() {
    return isScip1;
  }

  boolean isLit() {
    return lit;
  }

  private void accept(byte[] bytes) {
    for (char each : new String(bytes, US_ASCII).toCharArray()) {
      if (each == '\n') {
        obey(request.toString());
        request.setLength(0);
      } else {
        request.append(each);
      }
    }
  }

  private void obey(String command) {
    if (command.equals("SCIP2.0") && wakesUpWithScip1) {
      say(command, isScip1 ? "0" : sum("0E"));
      isScip1 = false;
      return;
    }
    if (isScip1) {
      say(command, "E"); // SCIP 1.1 has no such command
      return;
    }
    switch (command.substring(0, Math.min(2, command.length()))) {
      case "QT":
        produce(); // what is on its way still comes
        lit = false;
        measures = "";
        say(command, sum("00"));
        break;
      case "PP":
        say(
            command,
            sum("00"),
            parameter("MODL:UST-10LX (SmartUrg)"),
            parameter("DMIN:20"),
            parameter("DMAX:30000"),
            parameter("ARES:1440"),
            parameter("AMIN:0"),
            parameter("AMAX:1080"),
            parameter("AFRT:540"),
            parameter("SCAN:2400"));
        break;
      case "BM":
        say(command, sum(lit ? "02" : "00"));
        lit = true;
        break;
      case "MD":
        if (broken || !command.equals("MD0000108001000")) {
          say(command, sum(broken ? "50" : "04"));
        } else {
          measures = command;
          dueMicros = clock.getAsLong() + PERIOD_MICROS;
          say(command, sum("00"));
        }
        break;
      default:
        say(command, sum("0E"));
    }
  }

  private void produce() {
    while (!measures.isEmpty() && dueMicros <= clock.getAsLong()) {
      StringBuilder data = new StringBuilder();
      for (int step = 0; step < STEPS; step++) {
        data.append(encode((int) Math.round(1000 * world.applyAsDouble((step - FRONT) / 4.0)), 3));
      }
      String[] lines = new String[3 + (data.length() + 63) / 64];
      lines[0] = measures;
      lines[1] = sum("99");
      lines[2] = sum(encode((int) (dueMicros / 1000 & 0xFFFFFF), 4));
      for (int i = 3; i < lines.length; i++) {
        int from = 64 * (i - 3);
        lines[i] = sum(data.substring(from, Math.min(from + 64, data.length())));
      }
      say(lines);
      dueMicros += PERIOD_MICROS;
    }
  }

  static String encode(int value, int characters) {
    StringBuilder text = new StringBuilder();
    for (int i = characters - 1; i >= 0; i--) {
      text.append((char) (0x30 + (value >> 6 * i & 0x3F)));
    }
    return text.toString();
  }

  private static String parameter(String text) {
    String checked = sum(text);
    return text + ";" + checked.charAt(checked.length() - 1);
  }

  private static String sum(String text) {
    return text + (char) (0x30 + (text.chars().sum() & 0x3F));
  }

  private void say(String... lines) {
    if (mute) {
      return;
    }
    String last = lines[lines.length - 1];
    if (wrongSums) {
      char turned = (char) (last.charAt(last.length() - 1) ^ 1);
      lines[lines.length - 1] = last.substring(0, last.length() - 1) + turned;
    }
    link.fromDevice((String.join("\n", lines) + "\n\n").getBytes(US_ASCII));
  }
}
