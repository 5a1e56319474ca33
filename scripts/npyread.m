% [A, order] = npyread (file)   Read an array that NumPy or modal has written.
%
% Formats 1.0 and 2.0, little-endian float64, one or two dimensions, both orders.  A vector becomes
% a column.  order is 'F' (columns one after the other in the file) or 'C' (rows).  The header and
% the size of the data are verified.
function [A, order] = npyread (file)
  if (nargin != 1 || ! ischar (file))
    error ('usage: [A, order] = npyread (file)');
  end
  [f, why] = fopen (file, 'r', 'ieee-le');
  if (f < 0)
    error ('npyread: %s: cannot be opened: %s', file, why);
  end
  closing = onCleanup (@() fclose (f));

  magic = fread (f, [1, 8], 'uint8');
  if (numel (magic) < 8 || any (magic(1:6) != [147, double('NUMPY')]))
    error ('npyread: %s: is no .npy file, or cut short', file);
  end
  if (magic(7) == 1)
    bytes = fread (f, 1, 'uint16');
  elseif (magic(7) == 2)
    bytes = fread (f, 1, 'uint32');
  else
    error ('npyread: %s: is of format %d; 1.0 or 2.0 is expected', file, magic(7));
  end
  if (isempty (bytes))
    error ('npyread: %s: the header is cut short', file);
  end
  header = fread (f, [1, bytes], 'uint8=>char');
  if (numel (header) != bytes)
    error ('npyread: %s: the header is cut short', file);
  end

  descr = entry (file, header, 'descr', '''([^'']*)''');
  if (! strcmp (descr, '<f8'))
    error ('npyread: %s: holds ''%s''; little-endian float64 (''<f8'') is expected', file, descr);
  end
  fortran = strcmp (entry (file, header, 'fortran_order', '(True|False)'), 'True');
  extent = sscanf (entry (file, header, 'shape', '\(([0-9, ]*)\)'), '%d,')';
  if (numel (extent) == 1)
    extent(2) = 1;
  elseif (numel (extent) != 2)
    error ('npyread: %s: has %d dimensions; one or two are expected', file, numel (extent));
  end

  A = fread (f, prod (extent), 'double');
  if (numel (A) != prod (extent))
    error ('npyread: %s: the data are cut short: %d of %d numbers', file, numel (A), ...
           prod (extent));
  end
  if (! isempty (fread (f, 1, 'uint8')))
    error ('npyread: %s: holds more data than the header tells', file);
  end
  if (fortran)
    order = 'F';
    A = reshape (A, extent);
  else
    order = 'C';
    A = reshape (A, fliplr (extent)).';
  end
end

% What stands at key in the header's dictionary, in the form of pattern.
function value = entry (file, header, key, pattern)
  token = regexp (header, ['''', key, ''': *', pattern], 'tokens', 'once');
  if (isempty (token))
    error ('npyread: %s: the header lacks a valid %s', file, key);
  end
  value = token{1};
end
