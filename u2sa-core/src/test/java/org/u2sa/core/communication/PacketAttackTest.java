package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.frozen;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.io.IOException;
import java.security.GeneralSecurityException;
import java.util.Arrays;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.messages.safety.EmergencyStop;

/**
 * An observer that sends long packets, whole and byte by byte, each byte in a TLS record of its
 * own, while an operator stops the vehicle. {@link PacketFramerTest} counts the work.
 */
@Timeout(120)
class PacketAttackTest extends SecuredClients {
  private static final int MEGABYTE = 1 << 20;
  private static final int DRIPPED = 600;

  private RawClient observer() throws IOException, GeneralSecurityException {
    RawClient screen = new RawClient(TestAuthority.socket(directory), broker.port);
    assertThat(screen.introduce("screen", "screen", "screen")).isZero();
    return screen;
  }

  private void assertStopArrives(Connection pilot, String reason) {
    EmergencyStop stop = frozen(new EmergencyStop().active(true).reason(reason));
    pilot.publish(Channels.EMERGENCY_STOP, stop);
    soon().until(() -> inbox.messages.contains(stop));
  }

  /** Sends all but the last bytes at once, and those one by one. Returns whether it was put out. */
  private static boolean drip(RawClient client, byte[] packet) {
    try {
      client.send(Arrays.copyOf(packet, packet.length - DRIPPED));
      for (int i = packet.length - DRIPPED; i < packet.length; i++) {
        client.send(new byte[] {packet[i]});
      }
      return client.isPutOut();
    } catch (IOException e) {
      return true; // reset
    }
  }

  @Test
  void longPacketsOtherThanPublish_putTheClientOutAndTheStopArrives()
      throws IOException, GeneralSecurityException {
    Connection pilot = connect("pilot");
    for (byte[] attack :
        new byte[][] {
          MqttPacketBytes.manyFilters(false, MEGABYTE), MqttPacketBytes.manyFilters(true, MEGABYTE)
        }) {
      try (RawClient dripping = observer()) {
        CompletableFuture<Boolean> putOut =
            CompletableFuture.supplyAsync(() -> drip(dripping, attack));
        assertStopArrives(pilot, "dripped " + attack[0]);
        assertThat(putOut.join()).isTrue();
      }
    }
    awaitLog("malformed packet", "\"screen\"");
  }

  @Test
  void filterBeyondThePacketsEnd_putsTheClientOutAndTheStopArrives()
      throws IOException, GeneralSecurityException {
    Connection pilot = connect("pilot");
    try (RawClient screen = observer()) {
      screen.send(MqttPacketBytes.unsubscribeBeyondItsEnd(2_000));
      assertStopArrives(pilot, "beyond the end");
      assertThat(screen.isPutOut()).isTrue();
    }
  }

  @Test
  void publishDrippedByteByByte_holdsNobodyUp() throws IOException, GeneralSecurityException {
    Connection pilot = connect("pilot");
    AtomicBoolean enough = new AtomicBoolean();
    try (RawClient screen = observer()) {
      CompletableFuture<Boolean> dripped =
          CompletableFuture.supplyAsync(
              () -> {
                try {
                  screen.send(new byte[] {0x30, (byte) 0xff, (byte) 0xff, 0x3f, 0, 1, 'x'});
                  while (!enough.get()) {
                    screen.send(new byte[1]);
                  }
                  return true;
                } catch (IOException e) {
                  return false;
                }
              });
      for (int i = 0; i < 20; i++) {
        assertStopArrives(pilot, "stop " + i);
      }
      enough.set(true);
      assertThat(dripped.join()).as("unfinished, but not too long").isTrue();
    }
  }
}
