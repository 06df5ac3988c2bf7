package org.toqa.fleet;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;

/**
 * A store with somebody between it and the fleet, who may look at each call, delay or refuse it.
 */
public final class TamperedStore {
  private TamperedStore() {}

  /** What happens instead of a call. */
  @FunctionalInterface
  public interface Between {
    Object call(String method, Object[] arguments, Call real) throws Throwable;
  }

  /** The call itself. */
  @FunctionalInterface
  public interface Call {
    Object go() throws Throwable;
  }

  public static FleetStore of(FleetStore store, Between between) {
    return (FleetStore)
        Proxy.newProxyInstance(
            FleetStore.class.getClassLoader(),
            new Class<?>[] {FleetStore.class},
            (proxy, method, arguments) ->
                between.call(
                    method.getName(),
                    arguments == null ? new Object[0] : arguments,
                    () -> {
                      try {
                        return method.invoke(store, arguments);
                      } catch (InvocationTargetException e) {
                        throw e.getCause();
                      }
                    }));
  }
}
