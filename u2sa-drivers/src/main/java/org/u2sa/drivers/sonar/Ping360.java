package org.u2sa.drivers.sonar;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Optional;
import org.u2sa.device.port.Sonar;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.LinkedDevice;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;

/**
 * Blue Robotics Ping360 scanning sonar: commanded to turn and ping, it replies with echo
 * intensities: messages 2601 and 2300 (bluerobotics/ping-protocol, ping360.json). Angles are
 * clockwise seen from above with the transducer on top; angle 0 is ahead.
 */
public final class Ping360 extends LinkedDevice<Sonar.Ping> implements Sonar {
  private static final int TRANSDUCER = 2601;
  private static final int DEVICE_DATA = 2300;
  private static final int DATA_HEAD_BYTES = 14;
  private static final int GRADIANS = 400;
  private static final double RAD_PER_GRADIAN = 2.0 * Math.PI / GRADIANS;
  private static final double PERIOD_STEP_S = 25e-9;
  private static final int MIN_PERIOD = 80;
  private static final int MAX_PERIOD = 40_000;
  private static final int SAMPLES = 600;
  private static final int FREQUENCY_KHZ = 740;
  private static final double MICROS_PER_S = 1e6;
  private static final double CYCLE_SHARE = 0.01; // pulse length relative to the echo time
  private static final long ANSWER_WITHIN_MICROS =
      Clock.micros(4.0); // from the message description
  private static final byte[] AUTO_BAUD = {'U', 'U', 'U', 'U', 'U', 'U', 'U'};

  private final PingFramer framer = new PingFramer(this::take, this::refuse);
  private final double soundMps;
  private final int stepGradians;
  private final int gain;
  private final int period; // sample period [25 ns]
  private int angle;
  private boolean isAsked;
  private long askedMicros;
  private long heardMicros; // arrival time of the bytes being parsed

  /**
   * Uses the link; closing the device closes it.
   *
   * @param reachM maximum range [m]
   * @param soundMps speed of sound in the water [m/s]
   * @param stepGradians step between pings, clockwise; 400 per turn
   * @param gain 0 low, 1 normal, 2 high
   */
  public Ping360(ByteLink link, double reachM, double soundMps, int stepGradians, int gain) {
    super(link);
    this.soundMps = soundMps;
    this.stepGradians = stepGradians;
    this.gain = gain;
    // two-way travel: 2 r = c · n · T
    double exact = 2.0 * reachM / (soundMps * SAMPLES * PERIOD_STEP_S);
    period = (int) Math.max(MIN_PERIOD, Math.min(MAX_PERIOD, Math.round(exact)));
  }

  @Override
  protected void found(long nowMicros) {
    framer.reset();
    isAsked = false;
    link.write(AUTO_BAUD); // lets the device detect the baud rate
  }

  @Override
  protected void hear(byte[] bytes, int length, long nowMicros) {
    heardMicros = nowMicros;
    framer.accept(bytes, length);
  }

  private void take(ByteBuffer data, int id) {
    if (id != DEVICE_DATA || data.capacity() < DATA_HEAD_BYTES) {
      return;
    }
    int said = data.getShort(2) & 0xFFFF;
    int saidPeriod = data.getShort(6) & 0xFFFF;
    int count = data.getShort(12) & 0xFFFF;
    if (said >= GRADIANS || count > data.capacity() - DATA_HEAD_BYTES || saidPeriod == 0) {
      refuse("device data with invalid numbers");
      return;
    }
    isAsked = false;
    angle = (said + stepGradians) % GRADIANS;
    if (count == 0) {
      return; // reply to a turn without a ping
    }
    byte[] strengths = Arrays.copyOfRange(data.array(), DATA_HEAD_BYTES, DATA_HEAD_BYTES + count);
    double bearing = -Math.IEEEremainder(said * RAD_PER_GRADIAN, 2.0 * Math.PI);
    double metres = 0.5 * soundMps * saidPeriod * PERIOD_STEP_S;
    latest = Optional.of(new Ping(heardMicros, bearing, metres, strengths));
  }

  @Override
  protected void act(long nowMicros) {
    boolean isLate = isAsked && nowMicros - askedMicros > ANSWER_WITHIN_MICROS;
    if (isLate) {
      refuse("no answer");
    }
    if (link.isConnected() && (!isAsked || isLate)) {
      isAsked = link.write(PingFramer.of(TRANSDUCER, settings()));
      askedMicros = nowMicros;
    }
  }

  private byte[] settings() {
    double echoS = SAMPLES * period * PERIOD_STEP_S;
    int pulseMicros = (int) Math.max(5, Math.min(500, CYCLE_SHARE * echoS * MICROS_PER_S));
    ByteBuffer settings = ByteBuffer.allocate(14).order(ByteOrder.LITTLE_ENDIAN);
    settings.put((byte) 1).put((byte) gain).putShort((short) angle).putShort((short) pulseMicros);
    settings.putShort((short) period).putShort((short) FREQUENCY_KHZ).putShort((short) SAMPLES);
    return settings.put((byte) 1).put((byte) 0).array();
  }

  /** Provider of SONAR = PING360. */
  public static final class Provider extends LinkProvider<Sonar> {
    private record Variables(
        @Variable(unit = "m", min = 1, max = 75, ifAbsent = 20) @Description("PING360: range.")
            double sonarReach,
        @Variable(unit = "m/s", min = 1300, max = 1700, ifAbsent = 1500)
            @Description(
                "PING360: speed of sound in the water: 1500 in the sea, 1450 in a cold lake.")
            double soundSpeed,
        @Variable(min = 1, max = 100, ifAbsent = 4)
            @Description("PING360: step between pings in gradians (400 per turn).")
            int stepGradians,
        @Variable(min = 0, max = 2, ifAbsent = 1)
            @Description("PING360: analog gain: 0 low, 1 normal, 2 high.")
            int gain) {}

    public Provider() {
      super(
          Sonar.class,
          Variables.class,
          (name, link, own) ->
              new Ping360(link, own.sonarReach(), own.soundSpeed(), own.stepGradians(), own.gain()),
          "PING360");
    }
  }
}
