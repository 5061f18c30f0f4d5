#include "ComponentFactors.h"

namespace galaxy
{
QVariantList ComponentFactors::list() const
{
  QVariantList all;
  for (auto entry = this->values.begin(); entry != this->values.end(); ++entry)
  {
    all.append(entry.key());
    all.append(entry.value());
  }
  return all;
}

void ComponentFactors::set(const QVariantList& list)
{
  this->values.clear();
  for (int k = 0; k + this->width < list.size(); k += this->width + 1)
  {
    this->values[list[k].toString()] = list.mid(k + 1, this->width);
  }
}

double ComponentFactors::value(const QString& name, double fallback) const
{
  return this->has(name) ? this->values[name].front().toDouble() : fallback;
}

bool ComponentFactors::change(const QString& name, const QVariantList& list)
{
  if (list == this->values.value(name))
  {
    return false;
  }
  if (list.isEmpty())
  {
    this->values.remove(name);
  }
  else
  {
    this->values[name] = list;
  }
  return true;
}

bool ComponentFactors::change(const QString& name, double value, double fallback)
{
  if (value == this->value(name, fallback))
  {
    return false;
  }
  return this->change(name, value == fallback ? QVariantList() : QVariantList{ value });
}
}
