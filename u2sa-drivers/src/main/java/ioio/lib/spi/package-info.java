/** The class that the IOIO library requires its user to provide. Nothing else belongs here. */
package ioio.lib.spi;
