package org.u2sa.drivers.range;

import java.util.EnumSet;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.u2sa.device.port.LaserScanner;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.LinkedDevice;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.RangeScan;

/**
 * Operates an RPLIDAR: stops it, queries its health, resets it after a protection stop, starts the
 * motor if needed, starts the standard scan, and restarts when scans stop arriving.
 *
 * <p>The A1's motor runs permanently or by DTR. From the A2 on, the motor is driven by the USB
 * adapter, whose presence is queried and which accepts SET_MOTOR_PWM (Slamtec's rplidar_sdk,
 * sl_lidar_cmd.h and sl_lidar_driver.cpp; not in LR001).
 */
public final class Rplidar extends LinkedDevice<LaserScanner.Scan> implements LaserScanner {
  private static final int START = 0xA5;
  private static final int SET_MOTOR_PWM = 0xF0;
  private static final byte[] STOP = {(byte) 0xA5, 0x25};
  private static final byte[] RESET = {(byte) 0xA5, 0x40};
  private static final byte[] SCAN = {(byte) 0xA5, 0x20};
  private static final byte[] GET_HEALTH = {(byte) 0xA5, 0x52};
  private static final byte[] GET_INFO = {(byte) 0xA5, 0x50};
  private static final byte[] GET_MOTOR_BOARD = request(0xFF, 0, 0, 0, 0);
  private static final byte[] RUN_MOTOR = motor(660); // the SDK's default, of 1023
  private static final byte[] STOP_MOTOR = motor(0);
  private static final int FIRST_WITH_BOARD = 2; // A2, by the model's upper four bits
  private static final int WARNING = 1;
  private static final int ERROR = 2;

  private static final long STOPPED_AFTER_MICROS = Clock.micros(0.05);
  private static final long RESET_AFTER_MICROS = Clock.micros(1.0);
  private static final long ANSWER_WITHIN_MICROS = Clock.micros(0.5);
  private static final long MOTOR_MICROS = Clock.micros(0.5); // same delay as the SDK
  private static final long SPIN_UP_MICROS = Clock.micros(4.0);
  private static final long SCAN_WITHIN_MICROS =
      Clock.micros(1.0); // the slowest models scan at 2 Hz

  private enum State {
    STOPPING,
    HEALTH_ASKED,
    RESETTING,
    INFO_ASKED,
    BOARD_ASKED,
    MOTOR_STARTING,
    SCAN_ASKED,
    SPINNING_UP,
    SCANNING
  }

  private static final Set<State> MAY_BE_UNANSWERED =
      EnumSet.of(State.INFO_ASKED, State.BOARD_ASKED, State.MOTOR_STARTING);

  private final RplidarParser parser = new RplidarParser();
  private State state = State.STOPPING;
  private long untilMicros = Long.MIN_VALUE;
  private boolean runsMotor;
  private String trouble = "";

  public Rplidar(ByteLink link) {
    super(link);
  }

  /** Encodes a request: start, command, length, payload, and the XOR of all preceding bytes. */
  static byte[] request(int command, int... payload) {
    byte[] request = new byte[payload.length + 4];
    request[0] = (byte) START;
    request[1] = (byte) command;
    request[2] = (byte) payload.length;
    for (int i = 0; i < payload.length; i++) {
      request[3 + i] = (byte) payload[i];
    }
    int sum = 0;
    for (byte each : request) {
      sum ^= each;
    }
    request[request.length - 1] = (byte) sum;
    return request;
  }

  /**
   * Motor command.
   *
   * @param width PWM duty, 0…1023; 0 stops it
   */
  static byte[] motor(int width) {
    return request(SET_MOTOR_PWM, width & 0xFF, width >> 8);
  }

  @Override
  protected void found(long nowMicros) {
    stop(nowMicros);
  }

  @Override
  protected void hear(byte[] bytes, int length, long nowMicros) {
    if (state != State.STOPPING && state != State.RESETTING) {
      parser.accept(bytes, length, nowMicros);
    }
  }

  @Override
  protected void act(long nowMicros) {
    if (state == State.HEALTH_ASKED && parser.health().isPresent()) {
      judge(parser.health().get(), nowMicros);
    } else if (state == State.INFO_ASKED && parser.model().isPresent()) {
      if (parser.model().getAsInt() >> 4 >= FIRST_WITH_BOARD) {
        ask(GET_MOTOR_BOARD, State.BOARD_ASKED, nowMicros + ANSWER_WITHIN_MICROS);
      } else {
        scan(nowMicros);
      }
    } else if (state == State.BOARD_ASKED && parser.hasMotorBoard().isPresent()) {
      runsMotor = parser.hasMotorBoard().get();
      if (runsMotor) {
        ask(RUN_MOTOR, State.MOTOR_STARTING, nowMicros + MOTOR_MICROS);
      } else {
        scan(nowMicros);
      }
    } else if (state == State.SCAN_ASKED && parser.isScanning()) {
      enter(State.SPINNING_UP, nowMicros + SPIN_UP_MICROS);
    }
    Optional<RplidarParser.Turn> turn = parser.takeTurn();
    if (turn.isPresent()) {
      latest = Optional.of(new Scan(nowMicros, scanned(turn.get())));
      enter(State.SCANNING, nowMicros + SCAN_WITHIN_MICROS);
    }
    if (nowMicros >= untilMicros && link.isConnected()) {
      overdue(nowMicros);
    }
  }

  private static RangeScan scanned(RplidarParser.Turn turn) {
    double durationS = Clock.seconds(turn.endMicros() - turn.firstMicros());
    RangeScan scan =
        new RangeScan()
            .maxRange(RplidarParser.FARTHEST_M)
            .timeIncrement(turn.beams().isEmpty() ? 0.0 : durationS / turn.beams().size())
            .beams(turn.beams());
    scan.timestamp(turn.firstMicros());
    return scan;
  }

  private void judge(RplidarParser.Health health, long nowMicros) {
    if (health.status() == ERROR) {
      trouble = "the laser has stopped to protect itself, error " + hex(health) + "; it is reset";
      ask(RESET, State.RESETTING, nowMicros + RESET_AFTER_MICROS);
      return;
    }
    trouble = health.status() == WARNING ? "the laser warns: " + hex(health) : "";
    ask(GET_INFO, State.INFO_ASKED, nowMicros + ANSWER_WITHIN_MICROS);
  }

  private void scan(long nowMicros) {
    ask(SCAN, State.SCAN_ASKED, nowMicros + ANSWER_WITHIN_MICROS);
  }

  private static String hex(RplidarParser.Health health) {
    return String.format(Locale.ROOT, "0x%04X", health.errorCode());
  }

  private void overdue(long nowMicros) {
    if (state == State.STOPPING) {
      ask(GET_HEALTH, State.HEALTH_ASKED, nowMicros + ANSWER_WITHIN_MICROS);
    } else if (MAY_BE_UNANSWERED.contains(state)) {
      scan(nowMicros); // older models may not support the query
    } else {
      if (state != State.RESETTING) {
        refuse("no answer");
      }
      stop(nowMicros);
    }
  }

  private void stop(long nowMicros) {
    ask(STOP, State.STOPPING, nowMicros + STOPPED_AFTER_MICROS);
  }

  private void ask(byte[] request, State next, long until) {
    parser.reset();
    link.write(request); // an unsent request times out later
    enter(next, until);
  }

  private void enter(State next, long until) {
    state = next;
    untilMicros = until;
  }

  @Override
  public long malformed() {
    return super.malformed() + parser.malformed();
  }

  @Override
  protected String ownTrouble() {
    return trouble;
  }

  @Override
  public void close() {
    try {
      if (runsMotor) {
        link.write(STOP_MOTOR);
      }
      link.write(STOP);
    } finally {
      link.close();
    }
  }

  /** Provider of LIDAR = rplidar. */
  public static final class Provider extends LinkProvider<LaserScanner> {
    public Provider() {
      super(LaserScanner.class, Rplidar::new, "rplidar");
    }
  }
}
