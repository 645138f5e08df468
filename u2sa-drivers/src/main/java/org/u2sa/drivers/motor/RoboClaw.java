package org.u2sa.drivers.motor;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.DeviceProvider;
import org.u2sa.device.port.MotorController;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ByteLinks;
import org.u2sa.drivers.link.LinkedDevice;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.ServiceContext;

/**
 * A RoboClaw on a serial line, in packet serial mode (RoboClaw Series User Manual, Basicmicro). One
 * request at a time; duty-cycle commands and encoder requests alternate.
 *
 * <p>The controller is configured to stop after its serial time-out. Until it acknowledges that,
 * only duty 0 is sent, even if only its replies are lost.
 */
public final class RoboClaw extends LinkedDevice<MotorController.Counts>
    implements MotorController {
  private static final long ANSWER_WITHIN_MICROS = Clock.micros(0.1); // USB adapters take 0.016 s
  // A pause of 10 ms within a packet discards it ("Packet Timeout"), which resynchronises both
  // sides.
  private static final long QUIET_MICROS = Clock.micros(0.02);
  private static final long LOST_AFTER_MICROS = Clock.micros(0.5);
  private static final int BATTERY_EVERY = 100; // requests
  private static final double BATTERY_STEP_V = 0.1;

  private final int address;
  private final double serialTimeoutS;
  private final byte[] reply = new byte[64];
  private int replyLength;
  private RoboClawRequest asked; // null if no reply is pending
  private long askedMicros;
  private long quietUntilMicros;
  private long heardMicros;
  private boolean isSetUp;
  private int turn;
  private double first;
  private double second;
  private boolean isBySpeed; // whether first and second are counts per second
  private OptionalDouble batteryV = OptionalDouble.empty();

  /**
   * @param address 0x80…0x87, as set at the controller
   * @param serialTimeoutS time without a command after which the controller stops [s], 0.1…25.5
   */
  public RoboClaw(ByteLink link, int address, double serialTimeoutS) {
    super(link);
    this.address = address;
    this.serialTimeoutS = serialTimeoutS;
  }

  @Override
  protected void found(long nowMicros) {
    giveUp(nowMicros, 0);
    lost();
  }

  @Override
  protected void hear(byte[] bytes, int length, long nowMicros) {
    if (asked == null || replyLength + length > reply.length) {
      replyLength = reply.length; // no pending request, or excess bytes
    } else {
      System.arraycopy(bytes, 0, reply, replyLength, length);
      replyLength += length;
    }
  }

  @Override
  protected void act(long nowMicros) {
    if (!link.isConnected()) {
      found(nowMicros); // also restarts setup once reconnected
    }
    understand(nowMicros);
    if (asked != null && nowMicros - askedMicros > ANSWER_WITHIN_MICROS) {
      refuse("no answer");
      giveUp(nowMicros, QUIET_MICROS);
    }
    if (nowMicros - heardMicros > LOST_AFTER_MICROS) {
      lost();
    }
    if (asked == null && nowMicros >= quietUntilMicros) {
      ask(next(), nowMicros);
    }
  }

  private void understand(long nowMicros) {
    if (asked == null) {
      replyLength = 0; // replies to abandoned requests, or noise
    } else if (replyLength >= asked.replyLength()) {
      if (asked.isAnsweredBy(address, reply, replyLength)) {
        answered(nowMicros);
      } else {
        refuse("an answer with a wrong checksum");
        giveUp(nowMicros, QUIET_MICROS);
      }
    }
  }

  private void answered(long nowMicros) {
    RoboClawRequest request = asked;
    giveUp(nowMicros, 0);
    heardMicros = nowMicros;
    if (request.isSerialTimeout()) {
      isSetUp = true;
    } else if (request.isEncoders() && isSetUp) {
      latest =
          Optional.of(
              new Counts(
                  askedMicros,
                  RoboClawRequest.signed32(reply, 0),
                  RoboClawRequest.signed32(reply, 4),
                  batteryV));
    } else if (request.isBattery()) {
      batteryV = OptionalDouble.of(RoboClawRequest.unsigned16(reply, 0) * BATTERY_STEP_V);
    }
  }

  private void lost() {
    isSetUp = false; // it may have lost power
    batteryV = OptionalDouble.empty();
    latest = Optional.empty();
  }

  private void giveUp(long nowMicros, long quietMicros) {
    asked = null;
    replyLength = 0;
    quietUntilMicros = nowMicros + quietMicros;
  }

  private RoboClawRequest next() {
    turn++;
    if (turn % 2 == 0) {
      if (!isSetUp) {
        return RoboClawRequest.duty(0.0, 0.0);
      }
      return isBySpeed ? RoboClawRequest.speed(first, second) : RoboClawRequest.duty(first, second);
    }
    if (!isSetUp) {
      return RoboClawRequest.serialTimeout(serialTimeoutS);
    }
    return turn % BATTERY_EVERY == 1 ? RoboClawRequest.battery() : RoboClawRequest.encoders();
  }

  private void ask(RoboClawRequest request, long nowMicros) {
    if (link.write(request.packet(address))) {
      asked = request;
      askedMicros = nowMicros;
    }
  }

  @Override
  public void drive(double newFirst, double newSecond) {
    first = newFirst;
    second = newSecond;
    isBySpeed = false;
  }

  @Override
  public boolean turn(double firstPerS, double secondPerS) {
    first = firstPerS;
    second = secondPerS;
    isBySpeed = true;
    return true;
  }

  @Override
  public void stop(long nowMicros) {
    drive(0.0, 0.0);
    link.write(RoboClawRequest.duty(0.0, 0.0).packet(address));
    giveUp(nowMicros, QUIET_MICROS); // ignore late replies to this or earlier requests
  }

  @Override
  public void leave() {
    link.close();
  }

  @Override
  public void close() {
    try {
      link.write(RoboClawRequest.duty(0.0, 0.0).packet(address));
    } finally {
      link.close();
    }
  }

  /** Provider of CONTROLLER = ROBOCLAW. */
  public static final class Provider extends DeviceProvider<MotorController> {
    private record Variables(
        @Variable(min = 128, max = 135, ifAbsent = 128)
            @Description("ROBOCLAW: address set at the controller; 128 is 0x80.")
            int address) {}

    public Provider() {
      super(MotorController.class, "ROBOCLAW");
    }

    @Override
    protected List<Class<?>> variables() {
      return List.of(Variables.class);
    }

    @Override
    protected MotorController open(String name, ServiceContext context) {
      return new RoboClaw(
          ByteLinks.of(context),
          context.configuration().settings(Variables.class).get().address(),
          (Double) context.configuration().getVariable("SERIAL TIMEOUT"));
    }
  }
}
