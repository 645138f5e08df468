package org.u2sa.sim.sensor;

import java.util.EnumSet;
import java.util.Set;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;

/**
 * A u-blox receiver as its host sees it: bytes at a line's rate, NMEA or UBX, and answers to what
 * it is told. It obeys CFG-MSG, CFG-RATE and CFG-PRT, acknowledges CFG-CFG and CFG-NAV5, which
 * change nothing here, and refuses the rest of the configuration class.
 *
 * <p>Its time moves in {@link #advance}. Not safe for several threads.
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
  private static final int UART_OF_SIX = 1; // in the six rates of CFG-MSG: DDC, UART 1, …
  private static final int UBX = 1; // in the masks of CFG-PRT
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
  private int protocols = UBX | NMEA; // that it sends
  private long periodUs;
  private long nextUs;
  private GpsSample computed; // not sent yet
  private long sendUs;
  private long nowUs;

  /**
   * @param parameters how good it is; its rate and latency count here
   * @param utc what time it is
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
   * Time passes. Positions are computed at whole multiples of their period.
   *
   * @param micros the run's time [µs], not before that of the last call; often enough for its rate
   * @param blocked whether something keeps the satellites from being seen
   */
  public void advance(long micros, VehicleTruth truth, boolean blocked) {
    nowUs = micros;
    if (computed != null && micros >= sendUs) {
      send();
    }
    if (micros >= nextUs) {
      if (computed != null) {
        send(); // slower than its rate: late rather than lost
      }
      computed = model.sample(micros / US_PER_S, truth, blocked);
      sendUs = micros + latencyUs;
      nextUs = (micros / periodUs + 1) * periodUs;
    }
  }

  /** When {@link #advance} next has something to do [µs]. */
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

  /** The line on which it sends. */
  public UartTransmitter line() {
    return line;
  }

  /**
   * The host sent bytes.
   *
   * @param micros the run's time [µs], not before that of the last call
   * @param baud the host's rate: what comes at another than the receiver's is not understood
   * @param length how many of them count
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
    if (obeyed && id == CFG_PRT) { // answered at the old rate
      line.baud(number(payload, 8) | number(payload, 10) << 16);
    }
  }

  /** One rate for this port, or six of which one is for it; any rate above 0 counts as each. */
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
    return rate == 0; // others are off already
  }

  private boolean configurePort(byte[] payload) {
    if (payload.length != 20 || payload[0] != UART_1) {
      return false;
    }
    protocols = number(payload, 14);
    return true;
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
