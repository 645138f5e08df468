package org.u2sa.interfaces.configuration;

import java.io.IOException;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.net.URI;
import java.nio.channels.FileChannel;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.AccessMode;
import java.nio.file.CopyOption;
import java.nio.file.DirectoryStream;
import java.nio.file.FileStore;
import java.nio.file.FileSystem;
import java.nio.file.LinkOption;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.nio.file.StandardOpenOption;
import java.nio.file.WatchService;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.FileAttributeView;
import java.nio.file.attribute.UserPrincipalLookupService;
import java.nio.file.spi.FileSystemProvider;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The machine's files, with a list of what was done to them: {@code write X.xml}, {@code sync
 * X.xml}, {@code rename a → b}. Temporary names are cut to {@code *.tmp}.
 */
final class RecordingFileSystem extends FileSystemProvider {
  private final List<String> calls = new ArrayList<>(); // guarded by itself
  private final Names names = new Names();

  /** The same place, seen through this. */
  Path of(Path real) {
    return (Path)
        Proxy.newProxyInstance(
            RecordingFileSystem.class.getClassLoader(),
            new Class<?>[] {Path.class},
            new Seen(real, this));
  }

  /** A path of this file system: the real one, but for the way to the provider. */
  private record Seen(Path real, RecordingFileSystem disk) implements InvocationHandler {
    @Override
    public Object invoke(Object proxy, Method method, Object[] arguments) throws Throwable {
      if (method.getName().equals("getFileSystem")) {
        return disk.names;
      }
      Object[] unwrapped = arguments == null ? null : arguments.clone();
      for (int i = 0; unwrapped != null && i < unwrapped.length; i++) {
        unwrapped[i] =
            unwrapped[i] instanceof Path path ? RecordingFileSystem.real(path) : unwrapped[i];
      }
      try {
        Object result = method.invoke(real, unwrapped);
        return result instanceof Path path ? disk.of(path) : result;
      } catch (InvocationTargetException e) {
        throw e.getCause();
      }
    }
  }

  private static Path real(Path path) {
    return Proxy.isProxyClass(path.getClass())
        ? ((Seen) Proxy.getInvocationHandler(path)).real()
        : path;
  }

  /** What was done so far, oldest first. */
  List<String> calls() {
    synchronized (calls) {
      return new ArrayList<>(calls);
    }
  }

  void record(String call) {
    synchronized (calls) {
      calls.add(call);
    }
  }

  static String shown(Path path) {
    String name = real(path).getFileName().toString();
    return name.endsWith(".tmp") ? "*.tmp" : name;
  }

  private static FileSystemProvider provider(Path path) {
    return real(path).getFileSystem().provider();
  }

  @Override
  public FileChannel newFileChannel(
      Path path, Set<? extends OpenOption> options, FileAttribute<?>... attributes)
      throws IOException {
    FileChannel channel = provider(path).newFileChannel(real(path), options, attributes);
    return new RecordingFileChannel(channel, shown(path), this::record);
  }

  @Override
  public SeekableByteChannel newByteChannel(
      Path path, Set<? extends OpenOption> options, FileAttribute<?>... attributes)
      throws IOException {
    if (options.contains(StandardOpenOption.CREATE_NEW)) {
      record("create " + shown(path));
    }
    return options.contains(StandardOpenOption.WRITE)
        ? newFileChannel(path, options, attributes)
        : provider(path).newByteChannel(real(path), options, attributes);
  }

  @Override
  public void move(Path from, Path to, CopyOption... options) throws IOException {
    record("rename " + shown(from) + " → " + shown(to) + " " + Arrays.toString(options));
    provider(from).move(real(from), real(to), options);
  }

  @Override
  public void delete(Path path) throws IOException {
    provider(path).delete(real(path));
    record("delete " + shown(path));
  }

  @Override
  public void createLink(Path link, Path existing) throws IOException {
    record("link " + shown(existing) + " → " + shown(link));
    provider(link).createLink(real(link), real(existing));
  }

  @Override
  public void copy(Path from, Path to, CopyOption... options) throws IOException {
    record("copy " + shown(from) + " → " + shown(to));
    provider(from).copy(real(from), real(to), options);
  }

  @Override
  public DirectoryStream<Path> newDirectoryStream(
      Path folder, DirectoryStream.Filter<? super Path> filter) throws IOException {
    DirectoryStream<Path> entries =
        provider(folder).newDirectoryStream(real(folder), entry -> filter.accept(of(entry)));
    return new DirectoryStream<>() {
      @Override
      public Iterator<Path> iterator() {
        List<Path> seen = new ArrayList<>();
        entries.forEach(entry -> seen.add(of(entry)));
        return seen.iterator();
      }

      @Override
      public void close() throws IOException {
        entries.close();
      }
    };
  }

  @Override
  public void createDirectory(Path folder, FileAttribute<?>... attributes) throws IOException {
    provider(folder).createDirectory(real(folder), attributes);
  }

  @Override
  public boolean isSameFile(Path one, Path other) throws IOException {
    return provider(one).isSameFile(real(one), real(other));
  }

  @Override
  public boolean isHidden(Path path) throws IOException {
    return provider(path).isHidden(real(path));
  }

  @Override
  public FileStore getFileStore(Path path) throws IOException {
    return provider(path).getFileStore(real(path));
  }

  @Override
  public void checkAccess(Path path, AccessMode... modes) throws IOException {
    provider(path).checkAccess(real(path), modes);
  }

  @Override
  public <V extends FileAttributeView> V getFileAttributeView(
      Path path, Class<V> type, LinkOption... options) {
    return provider(path).getFileAttributeView(real(path), type, options);
  }

  @Override
  public <A extends BasicFileAttributes> A readAttributes(
      Path path, Class<A> type, LinkOption... options) throws IOException {
    return provider(path).readAttributes(real(path), type, options);
  }

  @Override
  public Map<String, Object> readAttributes(Path path, String wanted, LinkOption... options)
      throws IOException {
    return provider(path).readAttributes(real(path), wanted, options);
  }

  @Override
  public void setAttribute(Path path, String name, Object value, LinkOption... options)
      throws IOException {
    provider(path).setAttribute(real(path), name, value, options);
  }

  @Override
  public String getScheme() {
    return "recording";
  }

  @Override
  public FileSystem newFileSystem(URI uri, Map<String, ?> environment) {
    throw new UnsupportedOperationException();
  }

  @Override
  public FileSystem getFileSystem(URI uri) {
    return names;
  }

  @Override
  public Path getPath(URI uri) {
    throw new UnsupportedOperationException();
  }

  /** Leads from a path to this provider. */
  private final class Names extends FileSystem {
    private final FileSystem real = java.nio.file.FileSystems.getDefault();

    @Override
    public FileSystemProvider provider() {
      return RecordingFileSystem.this;
    }

    @Override
    public Set<String> supportedFileAttributeViews() {
      return real.supportedFileAttributeViews();
    }

    @Override
    public Path getPath(String first, String... more) {
      return of(real.getPath(first, more));
    }

    @Override
    public String getSeparator() {
      return real.getSeparator();
    }

    @Override
    public Iterable<Path> getRootDirectories() {
      return real.getRootDirectories();
    }

    @Override
    public Iterable<FileStore> getFileStores() {
      return real.getFileStores();
    }

    @Override
    public PathMatcher getPathMatcher(String pattern) {
      return real.getPathMatcher(pattern);
    }

    @Override
    public UserPrincipalLookupService getUserPrincipalLookupService() {
      return real.getUserPrincipalLookupService();
    }

    @Override
    public WatchService newWatchService() throws IOException {
      return real.newWatchService();
    }

    @Override
    public boolean isOpen() {
      return true;
    }

    @Override
    public boolean isReadOnly() {
      return false;
    }

    @Override
    public void close() {
      throw new UnsupportedOperationException();
    }
  }
}
