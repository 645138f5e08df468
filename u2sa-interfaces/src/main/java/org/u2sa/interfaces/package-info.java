/**
 * The contract that every service fulfils (thesis 3.2.1): configuration, logging and time, with the
 * implementations that come with the framework. Transport belongs in {@code communication}, XML
 * reading in {@code xml}, anything that knows a vehicle elsewhere.
 */
package org.u2sa.interfaces;
