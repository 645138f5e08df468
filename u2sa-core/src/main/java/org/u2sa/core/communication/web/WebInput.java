package org.u2sa.core.communication.web;

import io.netty.buffer.ByteBuf;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.handler.codec.ByteToMessageDecoder;
import io.netty.handler.codec.http.HttpServerCodec;
import io.netty.util.ReferenceCountUtil;
import java.util.concurrent.TimeUnit;
import org.u2sa.core.communication.limit.WorkQueue;

/**
 * Passes a client's bytes to the HTTP decoder, one request at a time and without its body, which no
 * request for a file has; after the upgrade to a WebSocket, to its decoder. Until the client has
 * logged in, both wait for their turn in the {@link WorkQueue}. Confined to its connection's
 * thread.
 */
public final class WebInput extends ChannelInboundHandlerAdapter {
  /** Longest request without its body; the decoder rejects one that is longer [bytes]. */
  static final int LONGEST_REQUEST = 12 * 1_024;

  /** Frames of this length are decoded in one go; then the session may have ended [bytes]. */
  private static final int FRAMES_AT_ONCE = 512;

  private static final int LOOK_AGAIN_MS = 2;
  private static final int INCOMPLETE = -1;
  private static final int END_LENGTH = 3; // "\n\r\n"
  private static final int DELETE = 0x7F;

  private final WorkQueue turns;
  private final WebConnection connection;
  private final WebSession session;
  private ByteBuf received; // not passed on yet; null: nothing
  private int searched; // number of its bytes that do not contain the end of a request
  private boolean isWaiting; // for its turn
  private boolean isRemoved;

  /**
   * @param connection answers the requests
   */
  public WebInput(WorkQueue turns, WebConnection connection, WebSession session) {
    this.turns = turns;
    this.connection = connection;
    this.session = session;
  }

  @Override
  public void channelRead(ChannelHandlerContext ctx, Object message) {
    ByteBuf bytes = (ByteBuf) message;
    if (isRemoved || session.isOut()) {
      bytes.release();
    } else if (ctx.pipeline().context(HttpServerCodec.class) != null) {
      request(ctx, bytes);
    } else if (session.isPending() || received != null) {
      keep(ctx, bytes);
      await(ctx, () -> passFrames(ctx));
    } else {
      ctx.fireChannelRead(bytes);
    }
  }

  private void request(ChannelHandlerContext ctx, ByteBuf bytes) {
    if (isWaiting || connection.isBusy()) {
      bytes.release();
      session.putOut(WebConnection.NOT_AWAITED);
      return;
    }
    keep(ctx, bytes);
    skipBlanks();
    int length = length();
    if (length != INCOMPLETE || received.readableBytes() > LONGEST_REQUEST) {
      await(ctx, () -> passRequest(ctx, length));
    }
  }

  private void keep(ChannelHandlerContext ctx, ByteBuf bytes) {
    received =
        received == null
            ? bytes
            : ByteToMessageDecoder.MERGE_CUMULATOR.cumulate(ctx.alloc(), received, bytes);
  }

  /** Empty lines before a request are ignored (RFC 9112, section 2.2). */
  private void skipBlanks() {
    while (searched == 0 && received.isReadable() && isBlank(received)) {
      received.skipBytes(1);
    }
  }

  private static boolean isBlank(ByteBuf bytes) {
    int first = bytes.getUnsignedByte(bytes.readerIndex());
    return first <= ' ' || first == DELETE;
  }

  /** Length of the request up to the empty line after its headers, or INCOMPLETE. */
  private int length() {
    int start = received.readerIndex();
    int at = Math.max(0, searched - END_LENGTH);
    searched = received.readableBytes();
    while ((at = received.indexOf(start + at, received.writerIndex(), (byte) '\n') - start) >= 0) {
      at++;
      int next = byteAt(start + at);
      if (next == '\n') {
        return at + 1;
      }
      if (next == '\r' && byteAt(start + at + 1) == '\n') {
        return at + 2;
      }
    }
    return INCOMPLETE;
  }

  private int byteAt(int index) {
    return index < received.writerIndex() ? received.getByte(index) : INCOMPLETE;
  }

  private void await(ChannelHandlerContext ctx, Runnable turn) {
    if (!isWaiting) {
      isWaiting = true;
      turns.run(turn, task -> ctx.executor().schedule(task, LOOK_AGAIN_MS, TimeUnit.MILLISECONDS));
    }
  }

  private void passRequest(ChannelHandlerContext ctx, int length) {
    ByteBuf all = begin();
    if (all == null) {
      return;
    }
    int passed = length == INCOMPLETE ? all.readableBytes() : length;
    connection.expect(passed < all.readableBytes());
    ctx.fireChannelRead(all.readRetainedSlice(passed));
    all.release();
    ctx.fireChannelReadComplete();
  }

  private void passFrames(ChannelHandlerContext ctx) {
    ByteBuf all = begin();
    if (all == null) {
      return;
    }
    while (all.isReadable() && !session.isOut()) {
      ctx.fireChannelRead(all.readRetainedSlice(Math.min(FRAMES_AT_ONCE, all.readableBytes())));
    }
    all.release();
    ctx.fireChannelReadComplete();
  }

  /** What has been received, now owned by the caller; null if the connection has ended. */
  private ByteBuf begin() {
    isWaiting = false;
    searched = 0;
    ByteBuf all = received;
    received = null;
    if (all != null && session.isOut()) {
      all.release();
      return null;
    }
    return all;
  }

  @Override
  public void handlerRemoved(ChannelHandlerContext ctx) {
    isRemoved = true;
    ReferenceCountUtil.release(received);
    received = null;
  }
}
