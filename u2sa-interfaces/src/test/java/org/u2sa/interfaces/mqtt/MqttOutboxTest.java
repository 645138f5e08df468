package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import org.junit.jupiter.api.Test;

/** What goes to a broker whose network takes little. */
class MqttOutboxTest {
  private final ByteArrayOutputStream sent = new ByteArrayOutputStream();
  private int takes;
  private boolean owes;
  private boolean wasInterrupted;
  private final MqttOutbox outbox =
      new MqttOutbox(
          new BrokerChannel() {
            @Override
            public int write(ByteBuffer from) {
              wasInterrupted = Thread.currentThread().isInterrupted();
              int count = Math.min(takes, from.remaining());
              for (int i = 0; i < count; i++) {
                sent.write(from.get());
              }
              return count;
            }

            @Override
            public int read(ByteBuffer to) {
              throw new UnsupportedOperationException();
            }

            @Override
            public boolean hasUnread() {
              return false;
            }

            @Override
            public boolean hasUnsent() {
              return owes;
            }

            @Override
            public boolean isOpen() {
              return true;
            }

            @Override
            public void close() {
              // nothing to close
            }
          });

  @Test
  void isEmpty_channelOwesSomething_isNot() {
    assertThat(outbox.isEmpty()).isTrue();
    owes = true;
    assertThat(outbox.isEmpty()).isFalse();
  }

  @Test
  void send_networkThatTakesLittle_keepsTheRestInOrder() throws IOException {
    int bytes = 100_000;
    for (int i = 0; i < bytes; i++) {
      outbox.room(1).put((byte) i);
      takes = i % 2;
      outbox.send();
    }
    assertThat(outbox.isEmpty()).isFalse();
    takes = bytes;
    outbox.send();

    assertThat(outbox.isEmpty()).isTrue();
    byte[] all = sent.toByteArray();
    assertThat(all).hasSize(bytes);
    for (int i = 0; i < bytes; i++) {
      assertThat(all[i]).isEqualTo((byte) i);
    }
  }

  @Test
  void room_networkThatTakesNothing_endsAtFourMebibytes() throws IOException {
    int megabytes = 0;
    for (ByteBuffer room = outbox.room(1 << 20); room != null; room = outbox.room(1 << 20)) {
      room.put(new byte[1 << 20]);
      outbox.send();
      megabytes++;
    }
    assertThat(megabytes).isEqualTo(4);
  }

  @Test
  void send_byAThreadThatWasInterrupted_sendsAndLeavesItInterrupted() throws IOException {
    outbox.room(1).put((byte) 1);
    takes = 1;
    Thread.currentThread().interrupt();

    outbox.send();

    assertThat(Thread.interrupted()).isTrue();
    assertThat(wasInterrupted).isFalse();
    assertThat(outbox.isEmpty()).isTrue();
  }
}
