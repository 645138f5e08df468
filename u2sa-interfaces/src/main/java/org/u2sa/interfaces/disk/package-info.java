/**
 * Access to files for services that must not wait for a disk. The files' formats belong to their
 * users.
 */
package org.u2sa.interfaces.disk;
