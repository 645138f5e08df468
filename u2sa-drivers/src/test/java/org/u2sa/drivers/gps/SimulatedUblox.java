package org.u2sa.drivers.gps;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.u2sa.drivers.link.MemoryLink;

/**
 * A receiver of u-blox at the other end of a link: knows the setup's messages byte by byte, answers
 * them, sends only what it was told to send, and forgets all when it is switched on again.
 */
public final class SimulatedUblox implements MemoryLink.Device {
  private static final List<String> COMMANDS =
      List.of(
          "CFG-PRT", "CFG-RATE", "CFG-MSG-0102", "CFG-MSG-0112", "CFG-MSG-0106", "CFG-MSG-0107");

  private final MemoryLink link;
  private final List<String> heard = new ArrayList<>();
  private final Set<String> switchedOn = new HashSet<>();
  private final Set<String> refuses = new HashSet<>();
  private boolean isDeaf;

  public SimulatedUblox(MemoryLink link) {
    this.link = link;
    link.with(this);
  }

  /** Lets it refuse a command. */
  void refuse(String command) {
    refuses.add(command);
  }

  /** Lets it answer no longer, or again. */
  void deaf(boolean deaf) {
    isDeaf = deaf;
  }

  /** The commands so far, by name; "?" for what it does not know. */
  List<String> heard() {
    return heard;
  }

  @Override
  public void accept(byte[] bytes) {
    String command =
        COMMANDS.stream()
            .filter(name -> Arrays.equals(UbxGolden.of(name), bytes))
            .findFirst()
            .orElse("?");
    heard.add(command);
    if (isDeaf || command.equals("?")) {
      return;
    }
    boolean accepts = !refuses.contains(command);
    if (accepts) {
      switchedOn.add(command);
    }
    link.fromDevice(
        UbxGolden.changed(accepts ? "ACK-ACK" : "ACK-NAK", 0, bytes[2], bytes[3])); // what it is to
  }

  /** Sends one solution, of what it was told to send. */
  public void solve() {
    send("CFG-MSG-0107", "NAV-PVT");
    send("CFG-MSG-0102", "NAV-POSLLH");
    send("CFG-MSG-0112", "NAV-VELNED");
    send("CFG-MSG-0106", "NAV-SOL");
  }

  private void send(String command, String message) {
    if (switchedOn.contains(command)) {
      link.fromDevice(UbxGolden.of(message));
    }
  }

  /** Is unplugged and plugged again: it forgets. */
  void restart() {
    switchedOn.clear();
    link.unplug();
    link.plug();
  }
}
