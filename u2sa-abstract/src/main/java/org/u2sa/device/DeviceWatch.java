package org.u2sa.device;

import java.util.Optional;
import org.u2sa.device.port.Attached;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.U2SAService;

/**
 * Reports in a service's log and health when its device is lost, falls silent, sends malformed
 * data, or recovers. Belongs to the service's thread.
 */
public final class DeviceWatch {
  private static final long NEVER_HEARD = Long.MIN_VALUE;
  private static final long GRACE_MICROS = Clock.micros(2.0); // to connect at the start

  private final U2SAService service;
  private final String device;
  private final Attached link;
  private final long silentMicros;
  private int connections;
  private Optional<Boolean> told = Optional.empty(); // last reported state: connected or lost
  private long firstMicros = NEVER_HEARD;
  private boolean wasHeard = true;
  private long sinceMicros = NEVER_HEARD;
  private long heardMicros = NEVER_HEARD;
  private long malformed;

  /**
   * @param device name in log and health
   * @param silentAfterS time without a readable message after which a connected device counts as
   *     silent [s]
   */
  public DeviceWatch(U2SAService service, String device, Attached link, double silentAfterS) {
    this.service = service;
    this.device = device;
    this.link = link;
    this.silentMicros = Clock.micros(silentAfterS);
  }

  /**
   * Checks the device, at each step before reading.
   *
   * @return whether it has reconnected, so that parsers must reset and it must be configured again
   */
  public boolean look(long nowMicros) {
    boolean isConnected = link.isConnected();
    boolean isNew = link.connections() != connections;
    connections = link.connections();
    if (isNew || sinceMicros == NEVER_HEARD) {
      sinceMicros = nowMicros;
      heardMicros = NEVER_HEARD;
    }
    tell(isConnected, nowMicros);
    lookForSilence(nowMicros, isConnected);
    return isNew;
  }

  private void tell(boolean isConnected, long nowMicros) {
    if (firstMicros == NEVER_HEARD) {
      firstMicros = nowMicros;
    }
    boolean isLooking = told.isEmpty() && nowMicros - firstMicros < GRACE_MICROS;
    if (told.equals(Optional.of(isConnected)) || !isConnected && isLooking) {
      return;
    }
    told = Optional.of(isConnected);
    if (isConnected) {
      service.log(device + " is connected");
    } else {
      service.trouble(device + " is lost: " + link.trouble());
    }
  }

  private void lookForSilence(long nowMicros, boolean isConnected) {
    boolean isSilent = isConnected && nowMicros - lastMicros() > silentMicros;
    if (isSilent && wasHeard) {
      wasHeard = false;
      service.trouble(
          device + " has sent no valid data for more than " + Clock.seconds(silentMicros) + " s");
    }
  }

  private long lastMicros() {
    return Math.max(sinceMicros, heardMicros);
  }

  /** Records that the device sent a readable message. */
  public void heard(long nowMicros) {
    heardMicros = nowMicros;
    if (!wasHeard) {
      wasHeard = true;
      service.log(device + " sends again");
    }
  }

  /** Whether the device is connected and has recently sent a readable message. */
  public boolean isHeard(long nowMicros) {
    return heardMicros != NEVER_HEARD
        && nowMicros - heardMicros <= silentMicros
        && link.isConnected();
  }

  /**
   * Records malformed data; logged at the 1st, 2nd, 4th, 8th….
   *
   * @param total since the start
   * @param why the last one was malformed; empty if unknown
   */
  public void malformed(long total, String why) {
    if (Long.highestOneBit(total) > Long.highestOneBit(malformed)) {
      service.trouble(
          device
              + " sent invalid data ("
              + total
              + " times so far)"
              + (why.isEmpty() ? "" : ", last: " + why));
    }
    malformed = total;
  }
}
