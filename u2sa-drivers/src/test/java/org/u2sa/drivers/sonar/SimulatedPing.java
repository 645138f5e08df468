package org.u2sa.drivers.sonar;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.drivers.link.MemoryLink;

/** A Ping360 and a Ping1D on one line, byte for byte, with a wall at one distance all around. */
final class SimulatedPing {
  private final MemoryLink link;
  private final double wallM;
  private final ByteArrayOutputStream heard = new ByteArrayOutputStream();
  private final List<Integer> angles = new ArrayList<>();
  private final ByteArrayOutputStream answers = new ByteArrayOutputStream();
  private final boolean isQuick;
  private int confidence = 90;

  /** One that answers at once if it is quick, or else when it is {@link #deliver told to}. */
  SimulatedPing(MemoryLink link, double wallM, boolean isQuick) {
    this.link = link;
    this.isQuick = isQuick;
    this.wallM = wallM;
    link.with(this::accept);
  }

  /** Says what it has to say. */
  synchronized void deliver() {
    link.fromDevice(answers.toByteArray());
    answers.reset();
  }

  /** Where it was told to look so far [gradians]. */
  synchronized List<Integer> angles() {
    return List.copyOf(angles);
  }

  synchronized void confidence(int percent) {
    confidence = percent;
  }

  private synchronized void accept(byte[] bytes) {
    heard.writeBytes(bytes);
    byte[] all = heard.toByteArray();
    int at = 0;
    while (at < all.length && all[at] == 'U') {
      at++;
    }
    heard.reset();
    if (at == all.length) {
      return;
    }
    ByteBuffer message =
        ByteBuffer.wrap(all, at, all.length - at).slice().order(ByteOrder.LITTLE_ENDIAN);
    int sum = 0;
    for (int i = 0; i < message.capacity() - 2; i++) {
      sum += message.get(i) & 0xFF;
    }
    int length = message.getShort(2);
    if (message.get(0) != 'B'
        || message.get(1) != 'R'
        || message.capacity() != 10 + length
        || message.getShort(8 + length) != (short) sum) {
      throw new AssertionError("not a message");
    }
    switch (message.getShort(4)) {
      case 2601:
        ping(message);
        break;
      case 6:
        distance(message.getShort(8));
        break;
      default:
        throw new AssertionError("message " + message.getShort(4));
    }
  }

  private void ping(ByteBuffer settings) {
    int angle = settings.getShort(10);
    int period = settings.getShort(14) & 0xFFFF;
    int samples = settings.getShort(18);
    angles.add(angle);
    ByteBuffer answer = ByteBuffer.allocate(14 + samples).order(ByteOrder.LITTLE_ENDIAN);
    answer.put(settings.get(8)).put(settings.get(9)).putShort((short) angle);
    answer.putShort(settings.getShort(12)).putShort((short) period);
    answer.putShort(settings.getShort(16)).putShort((short) samples).putShort((short) samples);
    for (int i = 0; i < samples; i++) {
      double nearM = 1500.0 * i * period * 25e-9 / 2.0;
      double farM = 1500.0 * (i + 1) * period * 25e-9 / 2.0;
      answer.put((byte) (nearM <= wallM && wallM < farM ? 250 : 10));
    }
    say(2300, answer.array());
  }

  private void distance(int wanted) {
    if (wanted != 1211) {
      throw new AssertionError("request for " + wanted);
    }
    ByteBuffer answer = ByteBuffer.allocate(5).order(ByteOrder.LITTLE_ENDIAN);
    say(1211, answer.putInt((int) (wallM * 1000.0)).put((byte) confidence).array());
  }

  private void say(int id, byte[] payload) {
    ByteArrayOutputStream message = new ByteArrayOutputStream();
    message.write('B');
    message.write('R');
    message.write(payload.length & 0xFF);
    message.write(payload.length >> 8);
    message.write(id & 0xFF);
    message.write(id >> 8);
    message.write(1);
    message.write(0);
    message.writeBytes(payload);
    int sum = 0;
    for (byte each : message.toByteArray()) {
      sum += each & 0xFF;
    }
    message.write(sum & 0xFF);
    message.write(sum >> 8);
    answers.writeBytes(message.toByteArray());
    if (isQuick) {
      deliver();
    }
  }
}
