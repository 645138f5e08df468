package org.u2sa.core.communication;

import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.handler.codec.mqtt.MqttPublishMessage;
import io.netty.util.ReferenceCountUtil;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.TimeUnit;

/**
 * Lets a client's packets in as fast as it may, and reads no more of them meanwhile, so that they
 * wait at the client and none is lost. Belongs to its connection's thread.
 */
final class Inflow extends ChannelInboundHandlerAdapter {
  private static final long LOOK_AGAIN_MS = 2;

  private final ConnectionFilter filter;
  private final ClientSession session;
  private final Deque<Object> held = new ArrayDeque<>(); // what was read already
  private final Allowance messages;
  private final Allowance bytes;
  private boolean paused;
  private ChannelHandlerContext context;

  Inflow(ConnectionFilter filter, ClientSession session) {
    this.filter = filter;
    this.session = session;
    long now = filter.nowMicros();
    messages = new Allowance(filter.limits().clientMessagesPerSecond(), now);
    bytes = new Allowance(filter.limits().clientBytesPerSecond(), now);
  }

  @Override
  public void handlerAdded(ChannelHandlerContext ctx) {
    context = ctx;
  }

  /** Reads no more until the session is ready. */
  void hold() {
    pause(context);
  }

  @Override
  public void channelRead(ChannelHandlerContext ctx, Object message) {
    if (held.isEmpty() && isOpen() && isInTurn(message)) {
      letIn(ctx, message);
    } else {
      held.add(message);
      pause(ctx);
    }
  }

  private boolean isOpen() {
    long now = filter.nowMicros();
    return session.isReady()
        && messages.isOpen(now)
        && bytes.isOpen(now)
        && !filter.backlog().isFull();
  }

  /** Every service answers a question: so they are counted for all connections of a user. */
  private boolean isInTurn(Object message) {
    return !session.isQuestion(message)
        || filter.questions().take(session.name(), filter.nowMicros());
  }

  private void letIn(ChannelHandlerContext ctx, Object message) {
    messages.take(1.0);
    if (message instanceof MqttPublishMessage publish) {
      bytes.take(publish.content().readableBytes());
    }
    ctx.fireChannelRead(message);
  }

  private void pause(ChannelHandlerContext ctx) {
    ctx.channel().config().setAutoRead(false);
    if (!paused) {
      paused = true;
      ctx.executor().schedule(() -> resume(ctx), LOOK_AGAIN_MS, TimeUnit.MILLISECONDS);
    }
  }

  private void resume(ChannelHandlerContext ctx) {
    paused = false;
    if (ctx.isRemoved()) {
      return;
    }
    boolean any = false;
    while (!held.isEmpty() && isOpen() && isInTurn(held.peek())) {
      letIn(ctx, held.poll());
      any = true;
    }
    if (any) {
      ctx.fireChannelReadComplete();
    }
    if (held.isEmpty() && isOpen()) {
      ctx.channel().config().setAutoRead(true);
    } else {
      pause(ctx);
    }
  }

  @Override
  public void handlerRemoved(ChannelHandlerContext ctx) {
    held.forEach(ReferenceCountUtil::release);
    held.clear();
  }
}
