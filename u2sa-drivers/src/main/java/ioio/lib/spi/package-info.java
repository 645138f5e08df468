/** The one class that the IOIO library expects from whoever uses it. Nothing else belongs here. */
package ioio.lib.spi;
