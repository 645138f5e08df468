package org.u2sa.sim.sensor;

import java.util.EnumSet;
import java.util.Set;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;

/**
 * Device side of a u-blox receiver: sends NMEA or UBX at the line rate and answers configuration
 * messages. It applies CFG-MSG, CFG-RATE and CFG-PRT, acknowledges CFG-CFG and CFG-NAV5 without
 * effect, and rejects the rest of the configuration class.
 *
 * <p>Time advances in {@link #advance}. Not thread-safe.
 */
public final class UbloxReceiver {
  private static final int BUFFER = 1024;
  private static final double US_PER_S = 1e6;
  private static final int CFG = 0x06;
  private static final int CFG_PRT = 0x00;
  private static final int CFG_MSG = 0x01;
  private static final int CFG_RATE = 0x08;
  private static final int CFG_CFG = 0x09;
  private static final int CFG_NAV5 = 0x24;
  private static final int ACK = 0x05;
  private static final int UART_1 = 1;
  private static final int UART_OF_SIX = 1; // index among the six rates of CFG-MSG: DDC, UART 1, …
  private static final int LOWEST_BAUD = 1_200;
  private static final int HIGHEST_BAUD = 921_600;
  private static final int UBX = 1; // bit in the masks of CFG-PRT
  private static final int NMEA = 2;
  private static final double MS_PER_S = 1e3;

  private final GpsModel model;
  private final double fastestHz;
  private final long latencyUs;
  private final NmeaGpsMessages nmea;
  private final UbxGpsMessages ubx;
  private final UartTransmitter line;
  private final UbxMessage.Reader requests = new UbxMessage.Reader(this::obey);
  private final Set<GpsMessage> messages = EnumSet.noneOf(GpsMessage.class);
  private int protocols = UBX | NMEA; // enabled output protocols
  private long periodUs;
  private long nextUs;
  private GpsSample computed; // pending
  private long sendUs;
  private long nowUs;

  /**
   * @param parameters error parameters, including rate and latency
   * @param utc maps simulated time to UTC
   */
  public UbloxReceiver(
      UbloxSettings settings,
      GpsParameters parameters,
      LocalPlane plane,
      UtcTime utc,
      NoiseStreams streams) {
    model = new GpsModel(parameters, plane, streams);
    fastestHz = parameters.rateHz();
    latencyUs = Math.round(parameters.latencyS() * US_PER_S);
    nmea = new NmeaGpsMessages(utc, settings.minuteDecimals());
    ubx = new UbxGpsMessages(utc);
    line = new UartTransmitter(settings.baud(), BUFFER);
    messages.addAll(settings.messages());
    periodUs = period(settings.rateHz());
  }

  private long period(double rateHz) {
    return Math.round(US_PER_S / Math.min(rateHz, fastestHz));
  }

  /**
   * Advances time. Positions are computed at multiples of their period.
   *
   * @param micros time of the run [µs], non-decreasing; call at least at the position rate
   * @param blocked whether the sky is blocked
   */
  public void advance(long micros, VehicleTruth truth, boolean blocked) {
    nowUs = micros;
    if (computed != null && micros >= sendUs) {
      send();
    }
    if (micros >= nextUs) {
      if (computed != null) {
        send(); // when called too rarely, positions are late rather than lost
      }
      computed = model.sample(micros / US_PER_S, truth, blocked);
      sendUs = micros + latencyUs;
      nextUs = (micros / periodUs + 1) * periodUs;
    }
  }

  /** Time at which {@link #advance} next has work [µs]. */
  public long nextUs() {
    return computed == null ? nextUs : Math.min(nextUs, sendUs);
  }

  private void send() {
    for (GpsMessage message : GpsMessage.values()) {
      if (messages.contains(message) && (protocols & (message.isNmea() ? NMEA : UBX)) != 0) {
        line.send(nowUs, bytes(message, computed));
      }
    }
    computed = null;
  }

  private byte[] bytes(GpsMessage message, GpsSample sample) {
    return switch (message) {
      case GGA -> nmea.gga(sample);
      case RMC -> nmea.rmc(sample);
      case VTG -> nmea.vtg(sample);
      case GST -> nmea.gst(sample);
      case POSLLH -> ubx.posllh(sample);
      case STATUS -> ubx.status(sample);
      case SOL -> ubx.sol(sample);
      case VELNED -> ubx.velned(sample);
      case PVT -> ubx.pvt(sample);
    };
  }

  /** Its transmit line. */
  public UartTransmitter line() {
    return line;
  }

  /**
   * Receives bytes from the host.
   *
   * @param micros time of the run [µs], non-decreasing
   * @param baud the host's rate; bytes at a different rate than the receiver's are ignored
   * @param length number of valid bytes
   */
  public void accept(long micros, int baud, byte[] bytes, int length) {
    nowUs = micros;
    if (baud == line.baud()) {
      requests.accept(bytes, length);
    }
  }

  private void obey(int messageClass, int id, byte[] payload) {
    if (messageClass != CFG) {
      return;
    }
    boolean answers = (protocols & UBX) != 0;
    boolean obeyed =
        switch (id) {
          case CFG_MSG -> configureMessage(payload);
          case CFG_RATE -> configureRate(payload);
          case CFG_PRT -> configurePort(payload);
          case CFG_CFG, CFG_NAV5 -> true;
          default -> false;
        };
    if (answers) {
      line.send(nowUs, new UbxMessage(ACK, obeyed ? 1 : 0, 2).u1(messageClass).u1(id).bytes());
    }
    if (obeyed && id == CFG_PRT) { // acknowledged at the old rate
      line.baud(baud(payload));
    }
  }

  /**
   * One rate for this port, or six of which one applies to it; any rate above 0 means every
   * position.
   */
  private boolean configureMessage(byte[] payload) {
    if (payload.length != 3 && payload.length != 8) {
      return false;
    }
    int rate = payload.length == 3 ? payload[2] : payload[2 + UART_OF_SIX];
    for (GpsMessage message : GpsMessage.values()) {
      if (message.is(payload[0] & 0xFF, payload[1] & 0xFF)) {
        if (rate == 0) {
          messages.remove(message);
        } else {
          messages.add(message);
        }
        return true;
      }
    }
    return rate == 0; // other messages are off anyway
  }

  private boolean configurePort(byte[] payload) {
    if (payload.length != 20
        || payload[0] != UART_1
        || baud(payload) < LOWEST_BAUD
        || baud(payload) > HIGHEST_BAUD) {
      return false;
    }
    protocols = number(payload, 14);
    return true;
  }

  private static int baud(byte[] payload) {
    return number(payload, 8) | number(payload, 10) << 16;
  }

  private boolean configureRate(byte[] payload) {
    if (payload.length != 6 || number(payload, 0) == 0 || number(payload, 2) == 0) {
      return false;
    }
    periodUs = period(MS_PER_S / (number(payload, 0) * (double) number(payload, 2)));
    nextUs = (nowUs / periodUs + 1) * periodUs;
    return true;
  }

  private static int number(byte[] payload, int at) {
    return payload[at] & 0xFF | (payload[at + 1] & 0xFF) << 8;
  }
}
