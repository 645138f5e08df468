import java.io.IOException;
import java.io.PrintStream;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Path;
import java.util.Collections;
import java.util.Enumeration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListSet;

/**
 * Runs a program whose one part is a phone application's classes, which find nothing that a phone lacks, and whose other part (command line,
 * simulator) is a desktop's. Run as {@code PhoneRun SIGNATURES REPORT PHONE.jar:… DESKTOP.jar:… MAIN ARGUMENTS…}; the report says how many of
 * the phone's classes ran and which classes they asked for in vain.
 */
final class PhoneRun {
  /** The virtual machine's own, which it asks for in the name of the class that uses reflection. */
  private static final String REFLECTION = "jdk.internal.reflect.";

  private PhoneRun() {}

  public static void main(String[] args) throws Exception {
    PhoneLoader phone = new PhoneLoader(urls(args[2]), new PhoneApi(Path.of(args[0])));
    DesktopLoader desktop = new DesktopLoader(urls(args[3]), phone);
    phone.desktop = desktop;
    Path report = Path.of(args[1]);
    Runtime.getRuntime().addShutdownHook(new Thread(() -> phone.report(report), "report"));
    Thread.currentThread().setContextClassLoader(desktop);
    String[] arguments = new String[args.length - 5];
    System.arraycopy(args, 5, arguments, 0, arguments.length);
    desktop.loadClass(args[4]).getMethod("main", String[].class).invoke(null, (Object) arguments);
  }

  private static String file(String className) {
    return className.replace('.', '/') + ".class";
  }

  private static URL[] urls(String classPath) throws MalformedURLException {
    String[] paths = classPath.split(":");
    URL[] urls = new URL[paths.length];
    for (int i = 0; i < paths.length; i++) {
      urls[i] = Path.of(paths[i]).toUri().toURL();
    }
    return urls;
  }

  /** Finds its own classes, and of the platform's those alone that a phone has. */
  private static final class PhoneLoader extends URLClassLoader {
    private final PhoneApi api;
    private final Set<String> loaded = ConcurrentHashMap.newKeySet();
    private final Set<String> refused = new ConcurrentSkipListSet<>();
    private DesktopLoader desktop; // whose services the phone's launcher makes by name, as a phone makes an application's own

    static {
      registerAsParallelCapable();
    }

    PhoneLoader(URL[] urls, PhoneApi api) {
      super(urls, null);
      this.api = api;
    }

    boolean owns(String name) {
      return findResource(file(name)) != null;
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
      synchronized (getClassLoadingLock(name)) {
        Class<?> found = findLoadedClass(name);
        if (found == null && (api.has(name.replace('.', '/')) || name.startsWith(REFLECTION))) {
          return getPlatformClassLoader().loadClass(name);
        }
        if (found == null && desktop.findResource(file(name)) != null) {
          return desktop.loadClass(name);
        }
        if (found == null) {
          try {
            found = findClass(name);
          } catch (ClassNotFoundException e) {
            refused.add(name);
            throw e;
          }
          loaded.add(name);
        }
        return found;
      }
    }

    void report(Path file) {
      try (PrintStream out = new PrintStream(file.toFile())) {
        out.println("loaded " + loaded.size());
        out.println("loaded of org.u2sa " + loaded.stream().filter(name -> name.startsWith("org.u2sa.")).count());
        refused.forEach(name -> out.println("refused " + name));
      } catch (IOException e) {
        System.err.println(file + ": cannot be written: " + e.getMessage());
      }
    }
  }

  /** Finds the phone's classes where there are such, then its own, then all of the platform's. */
  private static final class DesktopLoader extends URLClassLoader {
    private final PhoneLoader phone;

    static {
      registerAsParallelCapable();
    }

    DesktopLoader(URL[] urls, PhoneLoader phone) {
      super(urls, getPlatformClassLoader());
      this.phone = phone;
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
      return phone.owns(name) ? phone.loadClass(name) : super.loadClass(name, resolve);
    }

    @Override
    public URL getResource(String name) {
      URL found = phone.getResource(name);
      return found != null ? found : super.getResource(name);
    }

    /** Both parts' providers of a service. */
    @Override
    public Enumeration<URL> getResources(String name) throws IOException {
      List<URL> all = Collections.list(phone.findResources(name));
      all.addAll(Collections.list(super.getResources(name)));
      return Collections.enumeration(all);
    }
  }
}
