package org.u2sa.interfaces.configuration;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.MappedByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.ReadableByteChannel;
import java.nio.channels.WritableByteChannel;
import java.util.function.Consumer;

/** A channel of {@link RecordingFileSystem}: tells what is written and synced. */
final class RecordingFileChannel extends FileChannel {
  private final FileChannel real;
  private final String name;
  private final Consumer<String> record;

  RecordingFileChannel(FileChannel real, String name, Consumer<String> record) {
    this.real = real;
    this.name = name;
    this.record = record;
  }

  @Override
  public int write(ByteBuffer from) throws IOException {
    record.accept("write " + name);
    return real.write(from);
  }

  @Override
  public long write(ByteBuffer[] from, int offset, int length) throws IOException {
    record.accept("write " + name);
    return real.write(from, offset, length);
  }

  @Override
  public int write(ByteBuffer from, long position) throws IOException {
    record.accept("write " + name);
    return real.write(from, position);
  }

  @Override
  public void force(boolean metaData) throws IOException {
    real.force(metaData);
    record.accept("sync " + name);
  }

  @Override
  public int read(ByteBuffer to) throws IOException {
    int read = real.read(to);
    record.accept("read " + name + " " + read);
    return read;
  }

  @Override
  public long read(ByteBuffer[] to, int offset, int length) throws IOException {
    return real.read(to, offset, length);
  }

  @Override
  public int read(ByteBuffer to, long position) throws IOException {
    int read = real.read(to, position);
    record.accept("read " + name + " " + read);
    return read;
  }

  @Override
  public long position() throws IOException {
    return real.position();
  }

  @Override
  public FileChannel position(long position) throws IOException {
    real.position(position);
    return this;
  }

  @Override
  public long size() throws IOException {
    return real.size();
  }

  @Override
  public FileChannel truncate(long size) throws IOException {
    real.truncate(size);
    return this;
  }

  @Override
  public long transferTo(long position, long count, WritableByteChannel target) throws IOException {
    return real.transferTo(position, count, target);
  }

  @Override
  public long transferFrom(ReadableByteChannel source, long position, long count)
      throws IOException {
    return real.transferFrom(source, position, count);
  }

  @Override
  public MappedByteBuffer map(MapMode mode, long position, long size) throws IOException {
    return real.map(mode, position, size);
  }

  @Override
  public FileLock lock(long position, long size, boolean shared) throws IOException {
    return real.lock(position, size, shared);
  }

  @Override
  public FileLock tryLock(long position, long size, boolean shared) throws IOException {
    return real.tryLock(position, size, shared);
  }

  @Override
  protected void implCloseChannel() throws IOException {
    real.close();
  }
}
